package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.msc.ActiveCall.CALLED_TRANSACTION;
import static simgsm.center.msc.TestMobile.OUR_CALL;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.ProtocolViolation;
import simgsm.center.msc.call.ToneSender;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.SpeechCodec;

/** Signalled keys become sound for the other party (TS 23.014). */
class ToneSenderTest {
    private static final long SOURCE = 0xcafef00dL;

    private final TestNetwork network = new TestNetwork();
    private final ActiveCall call = network.activeCall("5550100", "5550200");
    private final TestMobile caller = call.caller();
    private final TestMobile called = call.called();
    private int sequence = 65_500;

    private static byte[] speech(int sequence) {
        byte[] octets = new byte[160];
        Arrays.fill(octets, (byte) 0x2a);
        return new RtpPacket(RtpPacket.A_LAW, sequence & 0xffff, 160L * sequence, SOURCE, octets).encode();
    }

    /** The caller speaks for this number of frames, and time passes with them. */
    private void speak(int frames) {
        for (int i = 0; i < frames; i++) {
            network.pass(Duration.ofMillis(20));
            caller.speak(speech(sequence++));
        }
    }

    private void pass(int frames) {
        for (int i = 0; i < frames; i++) {
            network.pass(Duration.ofMillis(20));
        }
    }

    private void start(char key) {
        caller.tell(new CallControl.StartDtmf(OUR_CALL, key));
        assertEquals(key, caller.next(CallControl.StartDtmfAcknowledge.class).key());
    }

    private void stop() {
        caller.tell(new CallControl.StopDtmf(OUR_CALL));
    }

    private void assertStopAcknowledged() {
        caller.next(CallControl.StopDtmfAcknowledge.class);
    }

    private static List<RtpPacket> packets(TestMobile mobile) throws ProtocolViolation {
        List<RtpPacket> packets = new ArrayList<>();
        for (byte[] octets : mobile.heard) {
            packets.add(RtpPacket.decode(octets));
        }
        return packets;
    }

    /** What a receiver at the other end makes of it: the keys, each with its milliseconds. */
    private static String keysHeard(TestMobile mobile) throws ProtocolViolation {
        StringBuilder keys = new StringBuilder();
        DtmfReceiver ear = new DtmfReceiver(new DtmfListener() {
            @Override
            public void keyDecided(DtmfDigit digit) {
                keys.append(digit.key().symbol());
            }
        });
        SpeechCodec decoder = SpeechCodec.Kind.A_LAW.open();
        for (RtpPacket packet : packets(mobile)) {
            ear.accept(decoder.decode(packet.payload()));
        }
        return keys.toString();
    }

    /** How many samples of the tone itself were heard: those that are not silence, speech aside. */
    private static long toneSamples(List<RtpPacket> packets) {
        long loud = 0;
        for (RtpPacket packet : packets) {
            short[] frame = SpeechCodec.Kind.A_LAW.open().decode(packet.payload());
            int last = frame.length;
            while (last > 0 && Math.abs(frame[last - 1]) <= 8) {
                last--;
            }
            loud += last;
        }
        return loud;
    }

    private static void assertNumbersRunOn(List<RtpPacket> packets) {
        for (int i = 1; i < packets.size(); i++) {
            RtpPacket before = packets.get(i - 1);
            RtpPacket packet = packets.get(i);
            assertEquals(before.sequence() + 1 & 0xffff, packet.sequence(), "frame " + i);
            assertEquals(before.timestamp() + 160 & 0xffff_ffffL, packet.timestamp(), "frame " + i);
            assertEquals(before.source(), packet.source(), "frame " + i);
        }
    }

    @ParameterizedTest
    @ValueSource(chars = {'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '*', '#', 'A', 'B', 'C', 'D'})
    void aHeldKeyTakesThePlaceOfItsMobilesSpeech(char key) throws Exception {
        speak(3);
        start(key);
        speak(6);
        stop();
        speak(1);
        assertStopAcknowledged();
        speak(9);
        List<RtpPacket> heard = packets(called);
        assertEquals(19, heard.size());
        assertNumbersRunOn(heard);
        assertEquals(String.valueOf(key), keysHeard(called));
        assertArrayEquals(speech(65_502), called.heard.get(2));
        assertArrayEquals(speech(sequence - 1), called.heard.get(18));
        assertEquals(6 * 160, toneSamples(heard.subList(3, 12)), 2, "as long as it was held");
    }

    @Test
    void speechComesBackAfterThePauseOf65Milliseconds() throws Exception {
        start('5');
        speak(5);
        stop();
        speak(6);
        SpeechCodec decoder = SpeechCodec.Kind.A_LAW.open();
        List<RtpPacket> heard = packets(called);
        for (int frame = 5; frame < 9; frame++) {
            for (short sample : decoder.decode(heard.get(frame).payload())) {
                assertTrue(Math.abs(sample) <= 8, "frame " + frame + " is silent");
            }
        }
        assertArrayEquals(speech(65_509), called.heard.get(9));
    }

    @Test
    void aKeyThatIsLetGoAtOnceSoundsFor70MillisecondsAndIsAcknowledgedThen() throws Exception {
        speak(1);
        start('9');
        stop();
        speak(3);
        assertTrue(caller.hasNothing(), "its tone is still sounding");
        speak(1);
        assertStopAcknowledged();
        speak(5);
        assertEquals("9", keysHeard(called));
        assertEquals(560, toneSamples(packets(called).subList(1, 8)), 2);
    }

    @Test
    void aToneOfAMobileThatDoesNotSpeakHasAStreamOfItsOwn() throws Exception {
        pass(10);
        start('*');
        pass(6);
        stop();
        pass(2);
        assertStopAcknowledged();
        pass(5);
        start('*');
        pass(6);
        stop();
        pass(8);
        assertStopAcknowledged();
        assertEquals("**", keysHeard(called));
        List<RtpPacket> heard = packets(called);
        for (int i = 1; i < heard.size(); i++) {
            assertEquals(heard.get(i - 1).sequence() + 1, heard.get(i).sequence());
            assertTrue(heard.get(i).timestamp() - heard.get(i - 1).timestamp() >= 160);
        }
        assertEquals(20, heard.size(), 2, "tone and pause, and nothing in between");
    }

    @Test
    void aGapInTheSpeechIsFilledAndWhatComesLateIsDropped() throws Exception {
        speak(2);
        start('7');
        speak(2);
        pass(5);
        assertEquals(8, called.heard.size(), "after 40 ms of patience a frame every 20 ms");
        caller.speak(speech(sequence++));
        caller.speak(speech(sequence++));
        assertEquals(8, called.heard.size(), "their time has passed");
        stop();
        sequence += 2;
        speak(20);
        assertStopAcknowledged();
        assertNumbersRunOn(packets(called));
        assertEquals("7", keysHeard(called));
    }

    @Test
    void aKeyThatIsNeverLetGoEndsAfter30SecondsAndItsStopIsAcknowledgedAllTheSame() throws Exception {
        start('3');
        speak(1_600);
        assertTrue(caller.hasNothing());
        assertEquals(30 * 8_000, toneSamples(packets(called).subList(0, 1_504)), 160);
        assertArrayEquals(speech(sequence - 1), called.heard.get(1_599));
        stop();
        assertStopAcknowledged();
    }

    @Test
    void keysThatComeWithoutWaitingAreHeardOneAfterTheOther() throws Exception {
        for (char key : "**#**20**".toCharArray()) {
            start(key);
            stop();
        }
        speak(70);
        for (int i = 0; i < 9; i++) {
            assertStopAcknowledged();
        }
        assertTrue(caller.hasNothing());
        assertEquals("**#**20**", keysHeard(called));
    }

    @Test
    void aFurtherKeyLetsGoTheOneThatIsDown() throws Exception {
        start('1');
        speak(5);
        start('2');
        speak(12);
        stop();
        speak(10);
        assertStopAcknowledged();
        assertTrue(caller.hasNothing());
        assertEquals("12", keysHeard(called));
    }

    @Test
    void moreKeysThanCanWaitAreRefusedWithCause47() {
        for (int i = 0; i < ToneSender.MAX_KEYS; i++) {
            start('1');
            stop();
        }
        caller.tell(new CallControl.StartDtmf(OUR_CALL, '1'));
        assertEquals(
                Cause.RESOURCES_UNAVAILABLE,
                caller.next(CallControl.StartDtmfReject.class).cause());
    }

    @Test
    void aStopWithoutAKeyIsAcknowledged() {
        stop();
        assertStopAcknowledged();
        speak(1);
        assertArrayEquals(speech(65_500), called.heard.get(0));
    }

    @Test
    void whileItRingsKeysAreRefusedWithCause63() {
        TestMobile third = network.attach("5550300");
        network.attach("5550400");
        third.dial("5550400");
        third.next(CallControl.CallProceeding.class);
        third.tell(new CallControl.StartDtmf(OUR_CALL, '1'));
        assertEquals(
                Cause.SERVICE_NOT_AVAILABLE,
                third.next(CallControl.StartDtmfReject.class).cause());
    }

    @Test
    void bothPartiesMaySignalAtTheSameTime() throws Exception {
        start('4');
        called.tell(new CallControl.StartDtmf(CALLED_TRANSACTION, '6'));
        called.next(CallControl.StartDtmfAcknowledge.class);
        for (int i = 0; i < 6; i++) {
            speak(1);
            called.speak(speech(i));
        }
        assertEquals("4", keysHeard(called));
        assertEquals("6", keysHeard(caller));
    }

    @Test
    void aFullRateSpeakersToneIsCleanALawAmongItsOwnFrames() throws Exception {
        byte[] fullRate = new RtpPacket(RtpPacket.GSM_FULL_RATE, 1, 160, SOURCE, new byte[33]).encode();
        caller.speak(fullRate);
        start('0');
        for (int i = 2; i < 8; i++) {
            caller.speak(new RtpPacket(RtpPacket.GSM_FULL_RATE, i, 160L * i, SOURCE, new byte[33]).encode());
        }
        assertArrayEquals(fullRate, called.heard.remove(0));
        assertNumbersRunOn(packets(called));
        assertEquals("0", keysHeard(called));
    }

    @Test
    void theEndOfTheCallEndsTheTone() {
        start('8');
        speak(3);
        caller.tell(new CallControl.Disconnect(OUR_CALL, Cause.NORMAL_CALL_CLEARING));
        int heard = called.heard.size();
        pass(20);
        assertEquals(heard, called.heard.size());
        caller.next(CallControl.Release.class);
        caller.tell(new CallControl.StartDtmf(OUR_CALL, '8'));
        assertEquals(
                Cause.SERVICE_NOT_AVAILABLE,
                caller.next(CallControl.StartDtmfReject.class).cause());
        caller.tell(new CallControl.ReleaseComplete(OUR_CALL, Optional.empty()));
    }
}
