// A stream of items worked on by several threads, its replies written in the order of the items, each as soon
// as those before it are out.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace burmester {

template <class Item, class Reply>
class OrderedMap {
 public:
  using Next = std::function<std::optional<Item>()>;            ///< called by run's thread; no value: the end
  using Work = std::function<Reply(std::size_t, const Item&)>;  ///< by any thread; items are counted from 0
  using Write = std::function<void(const Reply&)>;              ///< one call at a time, in order

  OrderedMap(Work work, Write write) : work_(std::move(work)), write_(std::move(write)) {}

  /// Returns when all is written; throws what `next`, `work` or `write` threw first.
  void run(int threads, const Next& next) {
    {
      std::vector<std::jthread> workers = start(threads);
      window_ = 16 * workers.size();
      try {
        while (wait_for_room())
          if (std::optional<Item> item = next())
            push(std::move(*item));
          else
            break;
      } catch (...) {
        fail(std::current_exception());
      }
      close();
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::vector<std::jthread> start(int threads) {
    std::vector<std::jthread> workers;
    for (int i = 0; i < threads; ++i) {
      try {
        workers.emplace_back([this] { serve(); });
      } catch (const std::system_error&) {  // as many as the system gives
        if (workers.empty()) throw;
        break;
      }
    }
    return workers;
  }

  void serve() {
    try {
      while (std::optional<std::pair<std::size_t, Item>> job = pop())
        finish(job->first, work_(job->first, job->second));
    } catch (...) {
      fail(std::current_exception());
    }
  }

  bool wait_for_room() {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [&] { return stopped_ || read_ - written_ < window_; });
    return !stopped_;
  }
  void push(Item item) {
    const std::lock_guard lock(mutex_);
    queue_.emplace_back(read_++, std::move(item));
    work_there_.notify_one();
  }
  std::optional<std::pair<std::size_t, Item>> pop() {
    std::unique_lock lock(mutex_);
    work_there_.wait(lock, [&] { return stopped_ || closed_ || !queue_.empty(); });
    if (stopped_ || queue_.empty()) return std::nullopt;
    auto job = std::move(queue_.front());
    queue_.pop_front();
    return job;
  }
  void finish(std::size_t index, Reply reply) {
    const std::lock_guard lock(mutex_);
    done_.emplace(index, std::move(reply));
    for (auto first = done_.begin(); !stopped_ && first != done_.end() && first->first == written_;
         first = done_.begin()) {
      write_(first->second);
      done_.erase(first);
      ++written_;
    }
    room_.notify_one();
  }
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    work_there_.notify_all();
  }
  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
    stopped_ = true;
    work_there_.notify_all();
    room_.notify_all();
  }

  Work work_;
  Write write_;
  std::mutex mutex_;
  std::condition_variable room_, work_there_;
  std::deque<std::pair<std::size_t, Item>> queue_;
  std::map<std::size_t, Reply> done_;
  std::size_t read_ = 0, written_ = 0, window_ = 1;
  bool closed_ = false, stopped_ = false;
  std::exception_ptr failure_;
};

}  // namespace burmester
