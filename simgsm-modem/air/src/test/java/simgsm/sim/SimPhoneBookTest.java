package simgsm.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SimPhoneBookTest {
    private static final SimPhoneBook.Entry ANA = new SimPhoneBook.Entry("+5550101", "Ana");

    private final SimPhoneBook book = new SimPhoneBook();

    @Test
    void anEntryIsWrittenReplacedAndErasedAtItsPlace() {
        assertEquals(Optional.of(1), book.free());
        book.write(1, new SimPhoneBook.Entry("5550102", "Bea"));
        book.write(1, ANA);
        assertEquals(Map.of(1, ANA), book.entries());
        assertEquals(Optional.of(2), book.free());
        book.erase(1);
        assertEquals(Map.of(), book.entries());
        assertEquals(3, book.version());
    }

    @Test
    void aFullBookHasNoFreePlace() {
        for (int place = 1; place <= SimPhoneBook.CAPACITY; place++) {
            book.write(place, ANA);
        }
        assertEquals(Optional.empty(), book.free());
    }

    @ParameterizedTest
    @CsvSource({"0, 1, a", "101, 1, a", "1, 123456789012345678901, a", "1, 1, abcdefghijklmnopqrstu"})
    void whatDoesNotFitIsRefused(int place, String number, String name) {
        SimPhoneBook.Entry entry = new SimPhoneBook.Entry(number, name);
        assertThrows(IllegalArgumentException.class, () -> book.write(place, entry));
        assertEquals(0, book.version());
    }
}
