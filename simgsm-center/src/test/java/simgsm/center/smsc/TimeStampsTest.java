package simgsm.center.smsc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

class TimeStampsTest {
    private static final Instant NOW = Instant.parse("2026-11-21T12:00:45.250Z");
    private static final SmsAddress ALICE = SmsAddress.of(new Msisdn("5550100"));
    private static final Msisdn BOB = new Msisdn("5550101");

    private final TimeStamps stamps = new TimeStamps();

    private static SubmitTpdu submit(String text) {
        return SubmitTpdu.of(1, SmsAddress.of(BOB), UserData.of(text));
    }

    private Instant stamp(String text, Instant now) {
        return stamps.stamp(ALICE, BOB, submit(text), now);
    }

    @Test
    void oneMessageIsStampedWithTheTime() {
        assertEquals(NOW, stamp("hello", NOW));
    }

    @Test
    void twoMessagesAlikeInOneSecondAreStampedASecondApart() {
        stamp("hello", NOW);
        assertEquals(Instant.parse("2026-11-21T12:00:46Z"), stamp("hello", NOW.plusMillis(10)));
        assertEquals(Instant.parse("2026-11-21T12:00:47Z"), stamp("hello", NOW.plusMillis(1_000)));
    }

    @Test
    void messagesThatDifferMayBearOneStamp() {
        stamp("hello", NOW);
        assertEquals(NOW, stamp("hullo", NOW));
        assertEquals(NOW, stamps.stamp(ALICE, new Msisdn("5550102"), submit("hello"), NOW));
        assertEquals(NOW, stamps.stamp(SmsAddress.ofLetters("Bank"), BOB, submit("hello"), NOW));
    }

    @Test
    void afterARestartInTheSameSecondTheSecondMessageIsStillAnother() {
        ShortMessage earlier = new ShortMessage(
                1,
                new Msisdn("5550100"),
                BOB,
                TpduCodec.encode(submit("hello")),
                NOW,
                NOW.plusSeconds(60),
                Optional.empty());
        stamps.restore(List.of(earlier));
        assertEquals(Instant.parse("2026-11-21T12:00:46Z"), stamp("hello", NOW.plusMillis(100)));
    }

    @Test
    void aFloodOfMessagesAlikeStaysWithinAnHourOfTheClock() {
        List<Instant> given = new ArrayList<>();
        for (int i = 0; i < 10_000; i++) {
            given.add(stamp("hello", NOW));
        }
        assertEquals(3_601, given.stream().distinct().count());
        assertEquals(Instant.parse("2026-11-21T13:00:45Z"), given.get(given.size() - 1));
    }

    @Test
    void aClockThatIsSetBackDoesNotRepeatAStamp() {
        stamp("hello", NOW);
        assertEquals(Instant.parse("2026-11-21T12:00:46Z"), stamp("hello", NOW.minusSeconds(30)));
    }
}
