// A table that copies of a scene share: its entries never change, so a copy costs no memory.
#ifndef volumebench_SharedTable_h
#define volumebench_SharedTable_h

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace volumebench
{
template <typename T>
class SharedTable
{
public:
  SharedTable() = default;
  SharedTable(std::shared_ptr<const std::vector<T>> entries)
    : Entries(std::move(entries))
  {
  }
  SharedTable(std::vector<T> entries)
    : Entries(std::make_shared<const std::vector<T>>(std::move(entries)))
  {
  }

  bool empty() const { return this->size() == 0; }
  std::size_t size() const { return this->Entries ? this->Entries->size() : 0; }
  const T* data() const { return this->Entries ? this->Entries->data() : nullptr; }
  const T* begin() const { return this->data(); }
  const T* end() const { return this->data() + this->size(); }
  const T& front() const { return this->Entries->front(); }
  const T& back() const { return this->Entries->back(); }
  const T& operator[](std::size_t i) const { return (*this->Entries)[i]; }

private:
  std::shared_ptr<const std::vector<T>> Entries;
};
}

#endif
