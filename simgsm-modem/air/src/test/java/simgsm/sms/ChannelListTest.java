package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ChannelListTest {
    @Test
    void channelsAndRangesAreWantedAndNothingElse() {
        ChannelList list = ChannelList.parse("50, 919,4370-4399");
        for (int wanted : new int[] {50, 919, 4370, 4385, 4399}) {
            assertTrue(list.contains(wanted), "" + wanted);
        }
        for (int unwanted : new int[] {0, 49, 51, 4369, 4400, 65_535}) {
            assertFalse(list.contains(unwanted), "" + unwanted);
        }
    }

    @Test
    void allAndNoneAreWords() {
        assertTrue(ChannelList.parse("all").contains(0));
        assertTrue(ChannelList.parse("all").contains(65_535));
        assertFalse(ChannelList.parse("none").contains(50));
    }

    @ParameterizedTest
    @ValueSource(strings = {"all", "none", "50", "50,919,4370-4399", "0-65535"})
    void itIsWrittenAsItIsRead(String text) {
        ChannelList list = ChannelList.parse(text);
        assertEquals(list, ChannelList.parse(list.toString()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "x", "50,", "65536", "9-5", "-5", "5-", "1-2-3", "50;51"})
    void whatIsNoListIsRefusedAndNamed(String text) {
        IllegalArgumentException refusal = assertThrows(IllegalArgumentException.class, () -> ChannelList.parse(text));
        assertTrue(refusal.getMessage().startsWith("expected all, none, or channels"), refusal.getMessage());
    }

    @Test
    void moreThan255RangesAreRefused() {
        String many = "1" + ",1".repeat(ChannelList.MAX_RANGES);
        assertThrows(IllegalArgumentException.class, () -> ChannelList.parse(many));
    }
}
