// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/edit/observer.h"

#include <algorithm>

namespace quoin {

void ArrangementObserver::detach() {
  if (const auto list = list_.lock()) list->erase(std::remove(list->begin(), list->end(), this), list->end());
  list_.reset();
}

void ObserverList::attach(ArrangementObserver& observer, const dcel::Dcel& cells) {
  observer.detach();
  if (list_ == nullptr) list_ = std::make_shared<ArrangementObserver::List>();
  list_->push_back(&observer);
  observer.list_ = list_;
  observer.after_attach(cells);
}

}  // namespace quoin
