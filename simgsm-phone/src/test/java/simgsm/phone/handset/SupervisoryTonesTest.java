package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.Goertzel;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.PhoneKey;
import simgsm.speech.AudioOutput;
import simgsm.station.context.StationEvent;
import simgsm.tone.ToneLevel;
import simgsm.tone.ToneSet;

/** What the phone plays by itself. */
class SupervisoryTonesTest {
    private static final int RING_MILLIS = 3000;

    private static double amplitude(SupervisoryTones tones, double hertz, int millis) {
        short[] sound = new short[millis * 8];
        tones.addTo(sound);
        Goertzel filter = new Goertzel(hertz);
        filter.accept(sound, 0, sound.length);
        return filter.amplitude();
    }

    @ParameterizedTest
    @EnumSource(Cause.class)
    void whatACallEndsWithIsHeardForSecondsAtMost(Cause cause) {
        SupervisoryTones tones = new SupervisoryTones(ToneSet.EUROPEAN);
        tones.ringBack();
        tones.ended(cause);
        tones.addTo(new short[4000 * 8]);
        assertTrue(tones.isIdle());
    }

    @Test
    void aBusyCallSoundsBusyAndAnOrdinaryEndIsSilent() {
        SupervisoryTones tones = new SupervisoryTones(ToneSet.EUROPEAN);
        tones.ended(Cause.USER_BUSY);
        assertTrue(amplitude(tones, 425, 500) > 4000);
        assertTrue(amplitude(tones, 425, 500) < 10);
        tones.ended(Cause.NORMAL_CALL_CLEARING);
        assertTrue(tones.isIdle());
    }

    @Test
    void anAmericanPhoneSoundsAmerican() {
        SupervisoryTones tones = new SupervisoryTones(ToneSet.AMERICAN);
        tones.ringBack();
        short[] sound = new short[1000 * 8];
        tones.addTo(sound);
        for (double hertz : new double[] {440, 480}) {
            Goertzel filter = new Goertzel(hertz);
            filter.accept(sound, 0, sound.length);
            assertEquals(-19, ToneLevel.dbm0(filter.amplitude()), 0.2);
        }
    }

    @Test
    void ringBackGoesOnForAsLongAsTheOtherPhoneMayRing() {
        SupervisoryTones tones = new SupervisoryTones(ToneSet.EUROPEAN);
        tones.ringBack();
        tones.addTo(new short[175_000 * 8]);
        assertTrue(amplitude(tones, 425, 1000) > 4000);
        tones.addTo(new short[4_001 * 8]);
        assertTrue(tones.isIdle());
    }

    @Test
    void ourOwnRingWarblesASecondInThree() {
        SupervisoryTones tones = new SupervisoryTones(ToneSet.EUROPEAN);
        for (int i = 0; i < 3; i++) {
            tones.ringing(simgsm.phone.screen.RingTone.WARBLE);
            tones.addTo(new short[RING_MILLIS * 8 * i]);
            assertTrue(amplitude(tones, 880, 50) > 3000);
            assertTrue(amplitude(tones, 1175, 50) > 3000);
            tones.addTo(new short[900 * 8]);
            assertTrue(amplitude(tones, 880, 2000) < 10);
        }
    }

    /** The network's tones come as speech; ours are silent meanwhile, and none of it is a key. */
    @Test
    void aNetworkThatPlaysItsOwnTonesIsHeardInTheirPlace() {
        List<short[]> played = new ArrayList<>();
        Bench bench = new Bench(KeyMode.IN_BAND, new AudioOutput() {
            @Override
            public void play(short[] samples) {
                played.add(samples);
            }

            @Override
            public boolean isAudible() {
                return true;
            }

            @Override
            public void close() {}
        });
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.NetworkPlaysTones(true));
        bench.handset.accept(new StationEvent.CalledPartyAlerted());
        assertFalse(bench.handset.wantsTime());
        DtmfGenerator network = new DtmfGenerator();
        network.enqueue(DtmfKey.of('5'));
        while (!network.isIdle()) {
            short[] frame = new short[160];
            network.read(frame);
            bench.handset.accept(new StationEvent.SpeechReceived(frame));
            bench.speechMillis(20);
        }
        assertTrue(played.stream().anyMatch(frame -> frame[40] != 0));
        assertEquals("", bench.heardByFarEnd());
        assertTrue(bench.events.stream().noneMatch(event -> event.startsWith("tone")), bench.events.toString());

        bench.handset.accept(new StationEvent.NetworkPlaysTones(false));
        bench.station.release(Cause.USER_BUSY);
        bench.handset.accept(new StationEvent.NetworkPlaysTones(true));
        assertFalse(bench.handset.wantsTime());
        bench.tap(PhoneKey.END);
        assertTrue(bench.station.asked.contains("hangUp"), bench.station.asked.toString());
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
