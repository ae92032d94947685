package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import simgsm.abis.RtpPacket;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.speech.SpeechCodec;

/** The keys of the latest call, as the operator's window shows them. */
class KeyTapTest {
    private final TestNetwork network = new TestNetwork();

    @Test
    void keysOfBothSidesAreHeardInTheSpeechThatPasses() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        assertEquals("", heard());

        play(call.caller(), "**#**20**", SpeechCodec.Kind.A_LAW);
        play(call.called(), "63", SpeechCodec.Kind.A_LAW);
        play(call.caller(), "5", SpeechCodec.Kind.A_LAW);

        assertEquals("**#**20** [6] [3] 5", heard());
    }

    @Test
    void fullRateSpeechIsHeardToo() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        heard();

        play(call.caller(), "147", SpeechCodec.Kind.GSM_FULL_RATE);

        assertEquals("147", heard());
    }

    @Test
    void nothingIsDecodedWithoutAWatcher() {
        ActiveCall call = network.activeCall("5550100", "5550200");

        play(call.caller(), "1", SpeechCodec.Kind.A_LAW);

        assertEquals("", heard());
    }

    @Test
    void theNextCallBeginsWithAnEmptyLine() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        heard();
        play(call.caller(), "1", SpeechCodec.Kind.A_LAW);
        network.activeCall("5550101", "5550201");

        play(call.caller(), "2", SpeechCodec.Kind.A_LAW);

        assertEquals("", heard());
    }

    @Test
    void framesThatAreNoSpeechAreNoHarm() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        heard();

        call.caller().speak(new byte[] {(byte) 0x80, 8, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1});

        assertEquals("", heard());
    }

    @Test
    void aLongCallKeepsItsLatestKeys() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        heard();

        play(call.caller(), "1".repeat(80) + "23", SpeechCodec.Kind.A_LAW);

        assertEquals("1".repeat(78) + "23", heard());
    }

    private String heard() {
        return network.exchange.snapshot().latest().orElseThrow().text();
    }

    private static void play(TestMobile mobile, String keys, SpeechCodec.Kind kind) {
        DtmfGenerator generator = new DtmfGenerator();
        keys.chars().forEach(key -> generator.enqueue(DtmfKey.of((char) key)));
        SpeechCodec codec = kind.open();
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        int sequence = 0;
        while (!generator.isIdle()) {
            generator.read(frame);
            RtpPacket packet = new RtpPacket(kind.payloadType(), sequence, 160L * sequence, 1, codec.encode(frame));
            mobile.speak(packet.encode());
            sequence++;
        }
    }
}
