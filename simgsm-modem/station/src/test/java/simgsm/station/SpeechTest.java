package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.Setup;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;

class SpeechTest {
    private static final byte LOUD = (byte) 0x2a;

    private Scene scene;

    @BeforeEach
    void call() {
        call(StationOptions.STANDARD);
    }

    private void call(StationOptions options) {
        scene = Scene.registered(options);
        scene.station.dial(Scene.OTHER);
        scene.acceptService();
        TransactionIdentifier own = scene.expect(Setup.class).transaction();
        speak(9, LOUD);
        scene.pass(Scene.SECOND);
        assertTrue(scene.spoken.isEmpty(), "nothing is said before the call is active");
        scene.down(new Connect(own.answered()));
        scene.expect(ConnectAcknowledge.class);
        scene.reported.heard.clear();
    }

    private void speak(int sequence, byte octet) {
        byte[] payload = new byte[160];
        Arrays.fill(payload, octet);
        RtpPacket packet = new RtpPacket(RtpPacket.A_LAW, sequence & 0xffff, 0, 77, payload);
        scene.frame(IpaFrame.SPEECH, packet.encode());
    }

    private boolean isSilence(int frame) {
        return Arrays.equals(new short[160], scene.reported.heard.get(frame));
    }

    @Test
    void aFrameIsSaidEvery20MillisecondsFromTheMomentOfConnection() {
        scene.pass(0);
        assertEquals(1, scene.spoken.size());
        scene.pass(Scene.SECOND - 1);
        assertEquals(50, scene.spoken.size());
        scene.pass(1);
        assertEquals(51, scene.spoken.size());
        for (int i = 1; i < 51; i++) {
            assertEquals(
                    (scene.spoken.get(i - 1).sequence() + 1) & 0xffff,
                    scene.spoken.get(i).sequence());
            assertEquals(
                    scene.spoken.get(i - 1).timestamp() + 160,
                    scene.spoken.get(i).timestamp());
            assertEquals(RtpPacket.A_LAW, scene.spoken.get(i).payloadType());
        }
    }

    @Test
    void whatTheSourceSaysIsWhatGoesOut() {
        Arrays.fill(scene.speech, (short) 8);
        scene.pass(0);
        byte[] expected = new byte[160];
        Arrays.fill(expected, (byte) 0xd5);
        assertArrayEquals(expected, scene.spoken.get(0).payload());
    }

    @Test
    void aShortPauseOfTheOwnerIsMadeUpForAndALongOneIsNot() {
        scene.pass(0);
        scene.now += 1_900 * Scene.MILLI;
        scene.station.timePassed(scene.now);
        assertEquals(96, scene.spoken.size());
        scene.now += 10 * Scene.SECOND;
        scene.station.timePassed(scene.now);
        assertEquals(97, scene.spoken.size());
        scene.pass(20 * Scene.MILLI);
        assertEquals(98, scene.spoken.size());
        assertEquals(scene.spoken.get(96).sequence() + 1, scene.spoken.get(97).sequence());
    }

    @Test
    void framesThatTheSourceDropsAreMissingInTheSequence() {
        scene.pass(0);
        scene.framesDropped = 3;
        scene.pass(20 * Scene.MILLI);
        scene.framesDropped = 1_000;
        scene.pass(20 * Scene.MILLI);
        int first = scene.spoken.get(0).sequence();
        assertEquals(
                List.of(0, 4, 55),
                scene.spoken.stream()
                        .map(packet -> packet.sequence() - first & 0xffff)
                        .toList(),
                "a gap above 50 frames would be a new stream");
    }

    @Test
    void heardFramesAreHandedOnInOrder() {
        speak(100, LOUD);
        speak(101, LOUD);
        assertEquals(2, scene.reported.heard.size());
        assertEquals(160, scene.reported.heard.get(0).length);
        assertTrue(!isSilence(0) && !isSilence(1));
    }

    @Test
    void lostFramesAreSubstitutedByTheLastOneWeakerAndWeaker() {
        speak(0xfffe, LOUD);
        speak(0x0002, LOUD);
        assertEquals(5, scene.reported.heard.size());
        int[] levels = scene.reported.heard.stream()
                .mapToInt(frame -> Math.abs(frame[0]))
                .toArray();
        assertEquals(levels[0], levels[1]);
        assertEquals(levels[0] * Math.sqrt(0.5), levels[2], 1);
        assertEquals(levels[0] * 0.5, levels[3], 1);
        assertEquals(levels[0], levels[4]);
    }

    @Test
    void after320MillisecondsOfLossThereIsSilence() {
        speak(100, LOUD);
        speak(120, LOUD);
        assertEquals(21, scene.reported.heard.size());
        assertTrue(!isSilence(16) && isSilence(17) && isSilence(19));
    }

    @Test
    void aFrameWhoseTimeHasPassedIsDropped() {
        speak(100, LOUD);
        speak(101, LOUD);
        speak(100, LOUD);
        speak(101, LOUD);
        assertEquals(2, scene.reported.heard.size());
    }

    @Test
    void aLeapOfMoreThanASecondIsANewStream() {
        speak(100, LOUD);
        speak(151, LOUD);
        assertEquals(52, scene.reported.heard.size());
        speak(152 + 51, LOUD);
        assertEquals(53, scene.reported.heard.size());
    }

    @Test
    void fullRateSpeechIsUnderstoodAndOtherKindsAreDropped() {
        byte[] payload = SpeechCodec.Kind.GSM_FULL_RATE.open().encode(new short[160]);
        byte[] packet = new RtpPacket(RtpPacket.GSM_FULL_RATE, 0, 0, 77, payload).encode();
        scene.frame(IpaFrame.SPEECH, packet);
        assertEquals(1, scene.reported.heard.size());
        assertEquals(160, scene.reported.heard.get(0).length);
        packet[1] = 0;
        scene.frame(IpaFrame.SPEECH, packet);
        assertEquals(1, scene.reported.heard.size());
    }

    @Test
    void aStationThatSpeaksFullRateSends33OctetsAFrame() throws Exception {
        call(new StationOptions(SpeechCodec.Kind.GSM_FULL_RATE, CallAudioListener.NONE));
        DtmfGenerator key = new DtmfGenerator();
        key.enqueue(DtmfKey.FIVE, 100, 100);
        StringBuilder heard = new StringBuilder();
        DtmfReceiver ear = new DtmfReceiver(digit -> heard.append(digit.key().symbol()));
        SpeechCodec decoder = SpeechCodec.Kind.GSM_FULL_RATE.open();
        for (int i = 0; i < 10; i++) {
            key.read(scene.speech);
            scene.pass(20 * Scene.MILLI);
        }
        for (RtpPacket packet : scene.spoken) {
            assertEquals(RtpPacket.GSM_FULL_RATE, packet.payloadType());
            assertEquals(33, packet.payload().length);
            ear.accept(decoder.decode(packet.payload()));
        }
        assertEquals("5", heard.toString());
    }

    @Test
    void everyFrameIsDecodedByItsOwnPayloadTypeAndTheSnapshotNamesTheNewest() {
        assertEquals(Optional.empty(), scene.station.snapshot().heardCodec());
        assertEquals(
                Optional.of(SpeechCodec.Kind.A_LAW), scene.station.snapshot().codec());
        byte[] fullRate = SpeechCodec.Kind.GSM_FULL_RATE.open().encode(new short[160]);
        speak(10, LOUD);
        assertEquals(
                Optional.of(SpeechCodec.Kind.A_LAW), scene.station.snapshot().heardCodec());
        scene.frame(IpaFrame.SPEECH, new RtpPacket(RtpPacket.GSM_FULL_RATE, 11, 0, 77, fullRate).encode());
        assertEquals(
                Optional.of(SpeechCodec.Kind.GSM_FULL_RATE),
                scene.station.snapshot().heardCodec());
        speak(12, LOUD);
        assertEquals(3, scene.reported.heard.size());
        assertTrue(!isSilence(0) && !isSilence(2));
        scene.station.hangUp();
        assertEquals(Optional.empty(), scene.station.snapshot().heardCodec());
    }

    @Test
    void aCallInWhichNothingComesFor10SecondsIsReleasedWithCause41() {
        scene.reported.clear();
        scene.pass(5 * Scene.SECOND);
        speak(10, LOUD);
        scene.pass(10 * Scene.SECOND - 20 * Scene.MILLI);
        assertEquals(List.of(), scene.reported.lines());
        scene.pass(20 * Scene.MILLI);
        assertEquals(List.of("released 41"), scene.reported.lines());
        scene.expect(Disconnect.class);
    }

    @Test
    void aPauseOfTheOwnerIsNoSilence() {
        scene.reported.clear();
        scene.now += 60 * Scene.SECOND;
        scene.station.timePassed(scene.now);
        scene.pass(9 * Scene.SECOND);
        assertEquals(List.of(), scene.reported.lines());
    }

    @Test
    void whoListensInHearsBothDirectionsOfTheCall() {
        List<String> tapped = new ArrayList<>();
        call(new StationOptions(SpeechCodec.Kind.A_LAW, new CallAudioListener() {
            @Override
            public void callBegan() {
                tapped.add("began");
            }

            @Override
            public void sent(short[] frame) {
                tapped.add("sent " + frame[0]);
            }

            @Override
            public void received(short[] frame) {
                tapped.add("received " + frame.length);
            }

            @Override
            public void callEnded() {
                tapped.add("ended");
            }
        }));
        scene.speech[0] = 77;
        scene.pass(0);
        speak(10, LOUD);
        speak(12, LOUD);
        scene.station.hangUp();
        speak(13, LOUD);
        scene.pass(Scene.SECOND);
        assertEquals(List.of("began", "sent 77", "received 160", "received 160", "received 160", "ended"), tapped);
    }

    @Test
    void muLawIsNotSpoken() {
        assertThrows(
                IllegalArgumentException.class,
                () -> new StationOptions(SpeechCodec.Kind.MU_LAW, CallAudioListener.NONE));
    }

    @Test
    void afterTheHangUpNothingIsSaidOrHeard() {
        scene.pass(Scene.SECOND);
        scene.station.hangUp();
        scene.spoken.clear();
        speak(1, LOUD);
        scene.pass(Scene.SECOND);
        assertTrue(scene.spoken.isEmpty());
        assertTrue(scene.reported.heard.isEmpty());
        assertEquals(Optional.of(Scene.OTHER), scene.station.snapshot().peer());
    }
}
