package simgsm.timer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class BoundedMapTest {
    @Test
    void theOldestOfTenThousandIsForgotten() {
        BoundedMap<String, Integer> entries = new BoundedMap<>();
        for (int i = 0; i <= 10_000; i++) {
            entries.put("author " + i, i);
        }

        assertEquals(10_000, entries.size());
        assertFalse(entries.containsKey("author 0"));
        assertTrue(entries.containsKey("author 10000"));
    }

    @Test
    void aBoundedMapForgetsItsOldestKeyAndARenewedKeyIsNew() {
        BoundedMap<Integer, String> map = new BoundedMap<>(2);
        map.put(1, "a");
        map.put(2, "b");
        map.putNewest(1, "c");
        map.put(3, "d");
        assertEquals(List.of(1, 3), List.copyOf(map.keySet()));
        assertEquals("c", map.get(1));
    }
}
