package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.Goertzel;

/** What the phone plays by itself. */
class SupervisoryToneTest {
    private static double amplitude(SupervisoryTone tone, double hertz, int fromMillis, int toMillis) {
        SupervisoryTonePlayer player = new SupervisoryTonePlayer();
        player.start(tone);
        short[] sound = new short[toMillis * 8];
        player.addTo(sound);
        Goertzel filter = new Goertzel(hertz);
        filter.accept(sound, fromMillis * 8, toMillis * 8);
        return filter.amplitude();
    }

    @Test
    void ringingToneSoundsASecondAndIsSilentForFour() {
        assertTrue(amplitude(SupervisoryTone.RINGING, 425, 0, 1000) > 4000);
        assertTrue(amplitude(SupervisoryTone.RINGING, 425, 1000, 5000) < 10);
        assertTrue(amplitude(SupervisoryTone.RINGING, 425, 5000, 6000) > 4000);
    }

    @Test
    void theErrorToneClimbsInThreeSteps() {
        assertTrue(amplitude(SupervisoryTone.ERROR, 950, 0, 330) > 4000);
        assertTrue(amplitude(SupervisoryTone.ERROR, 1400, 330, 660) > 4000);
        assertTrue(amplitude(SupervisoryTone.ERROR, 1800, 660, 990) > 4000);
    }

    @ParameterizedTest
    @EnumSource(SupervisoryTone.class)
    void everyToneEnds(SupervisoryTone tone) {
        SupervisoryTonePlayer player = new SupervisoryTonePlayer();
        player.start(tone);
        player.addTo(new short[(tone.totalMillis + 20) * 8]);
        assertTrue(player.isIdle());
    }

    @Test
    void aBusyCallSoundsBusyAndAnOrdinaryEndIsSilent() {
        assertEquals(SupervisoryTone.BUSY, SupervisoryTone.of(Cause.USER_BUSY));
        assertEquals(SupervisoryTone.NONE, SupervisoryTone.of(Cause.NORMAL_CALL_CLEARING));
    }

    @Test
    void anIncomingCallWantsTimeUntilItIsAnswered() {
        Bench bench = new Bench();
        boolean[] wanted = new boolean[1];
        bench.handset.whenTimeIsWanted(() -> wanted[0] = true);
        bench.station.ring("5550101");
        assertTrue(wanted[0]);
        bench.millis(100);
        assertTrue(bench.handset.wantsTime());
        bench.tap(PhoneKey.CALL);
        bench.millis(40);
        assertFalse(bench.handset.wantsTime());
    }

    @Test
    void aKeyEndsTheBusyTone() {
        Bench bench = new Bench();
        bench.handset.dial(new Msisdn("5550200"));
        bench.station.release(Cause.USER_BUSY);
        bench.millis(1000);
        assertTrue(bench.handset.wantsTime());
        bench.tap(PhoneKey.END);
        bench.millis(400);
        assertFalse(bench.handset.wantsTime());
    }
}
