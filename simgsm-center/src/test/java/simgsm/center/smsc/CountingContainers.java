package simgsm.center.smsc;

import java.util.AbstractCollection;
import java.util.AbstractSet;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;

/**
 * Collections that count the work done on them: one step for each look-up, change and element that is gone through. What a
 * command costs can be asserted without a clock.
 */
final class CountingContainers implements ReceiverQueues.Containers {
    private final List<Map<?, ?>> made = new ArrayList<>();
    private long steps;

    @Override
    public <K, V> Map<K, V> inOrderOfInsertion() {
        Map<K, V> map = new CountingMap<>();
        made.add(map);
        return map;
    }

    @Override
    public <K, V> NavigableMap<K, V> sorted() {
        NavigableMap<K, V> map = new CountingTree<>();
        made.add(map);
        return map;
    }

    /** Steps that the action costs. */
    long stepsOf(Runnable action) {
        long before = steps;
        action.run();
        return steps - before;
    }

    /** Elements in all collections. */
    long held() {
        return made.stream().mapToLong(Map::size).sum();
    }

    private <T> Iterator<T> counted(Iterator<T> each) {
        return new Iterator<>() {
            @Override
            public boolean hasNext() {
                return each.hasNext();
            }

            @Override
            public T next() {
                steps++;
                return each.next();
            }

            @Override
            public void remove() {
                each.remove();
            }
        };
    }

    private <T> Set<T> counted(Set<T> set) {
        return new AbstractSet<>() {
            @Override
            public Iterator<T> iterator() {
                return counted(set.iterator());
            }

            @Override
            public int size() {
                return set.size();
            }
        };
    }

    private <T> Collection<T> counted(Collection<T> values) {
        return new AbstractCollection<>() {
            @Override
            public Iterator<T> iterator() {
                return counted(values.iterator());
            }

            @Override
            public int size() {
                return values.size();
            }
        };
    }

    private final class CountingMap<K, V> extends LinkedHashMap<K, V> {
        private static final long serialVersionUID = 1;

        @Override
        public V get(Object key) {
            steps++;
            return super.get(key);
        }

        @Override
        public V put(K key, V value) {
            steps++;
            return super.put(key, value);
        }

        @Override
        public V remove(Object key) {
            steps++;
            return super.remove(key);
        }

        @Override
        public Collection<V> values() {
            return counted(super.values());
        }

        @Override
        public Set<K> keySet() {
            return counted(super.keySet());
        }

        @Override
        public Set<Map.Entry<K, V>> entrySet() {
            return counted(super.entrySet());
        }
    }

    private final class CountingTree<K, V> extends TreeMap<K, V> {
        private static final long serialVersionUID = 1;

        @Override
        public V get(Object key) {
            steps++;
            return super.get(key);
        }

        @Override
        public V put(K key, V value) {
            steps++;
            return super.put(key, value);
        }

        @Override
        public V remove(Object key) {
            steps++;
            return super.remove(key);
        }

        @Override
        public Map.Entry<K, V> pollFirstEntry() {
            steps++;
            return super.pollFirstEntry();
        }

        @Override
        public Map.Entry<K, V> firstEntry() {
            steps++;
            return super.firstEntry();
        }

        @Override
        public Map.Entry<K, V> higherEntry(K key) {
            steps++;
            return super.higherEntry(key);
        }

        @Override
        public Map.Entry<K, V> ceilingEntry(K key) {
            steps++;
            return super.ceilingEntry(key);
        }

        @Override
        public Collection<V> values() {
            return counted(super.values());
        }

        @Override
        public Set<K> keySet() {
            return counted(super.keySet());
        }

        @Override
        public Set<Map.Entry<K, V>> entrySet() {
            return counted(super.entrySet());
        }
    }
}
