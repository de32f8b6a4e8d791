# WorkQueue::WorkQueue (cctools: Debian's coop-computing-tools-dev): static libraries with neither a CMake package
# nor a pkg-config file.
dumbbell_import(dttools WorkQueue::dttools cctools/link.h dttools ZLIB::ZLIB m)
dumbbell_import(WorkQueue WorkQueue::WorkQueue cctools/work_queue.h work_queue WorkQueue::dttools)
# Functions of it that are replaced: src/campaign/work_queue_manager.cpp says why.
foreach(replaced link_serve link_auth_password hash_table_nextkey cctools_warn cctools_notice)
  target_link_options(WorkQueue::WorkQueue INTERFACE LINKER:--wrap=${replaced})
endforeach()
