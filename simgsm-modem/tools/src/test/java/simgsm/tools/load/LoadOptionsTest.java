package simgsm.tools.load;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simgsm.console.HostPort;

class LoadOptionsTest {
    private static final HostPort CENTER = new HostPort("127.0.0.1", 3003);

    private static LoadOptions options(int phones, int calls, int messages, int seconds) {
        return new LoadOptions(CENTER, 7_000_000, phones, calls, messages, seconds, 0);
    }

    private static void refused(String option, int phones, int calls, int messages, int seconds) {
        String text = assertThrows(IllegalArgumentException.class, () -> options(phones, calls, messages, seconds))
                .getMessage();
        assertTrue(text.startsWith(option + ": expected "), text);
    }

    @Test
    void aCallTakesTwoPhones() {
        assertEquals(2, options(5, 2, 0, 1).calls());
        refused("--calls", 5, 3, 0, 1);
        refused("--calls", 1, 1, 0, 1);
    }

    @Test
    void numbersOutOfRangeAreNamed() {
        refused("--phones", 0, 0, 0, 1);
        refused("--phones", LoadOptions.MOST_PHONES + 1, 0, 0, 1);
        refused("--sms", 1, 0, LoadOptions.MOST_MESSAGES + 1, 1);
        refused("--seconds", 1, 0, 0, 0);
        refused("--seconds", 1, 0, 0, LoadOptions.MOST_SECONDS + 1);
    }

    @Test
    void theLastPhonesNumberMustStillBeOne() {
        assertEquals(
                "9999999999",
                new LoadOptions(CENTER, 9_999_999_998L, 2, 0, 0, 1, 0).number(1).digits());
        assertThrows(IllegalArgumentException.class, () -> new LoadOptions(CENTER, 9_999_999_999L, 2, 0, 0, 1, 0));
    }
}
