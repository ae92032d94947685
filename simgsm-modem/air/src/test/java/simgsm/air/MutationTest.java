package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmCodecTest;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessageTest;
import simgsm.abis.RtpPacket;
import simgsm.air.answer.ProtocolErrorAnswers;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** Spoilt messages by the hundred thousand: each gives a message or a violation, and nothing else ever. */
class MutationTest {
    private static final int ROUNDS = 3000;

    private interface Decoder {
        Object decode(byte[] octets) throws ProtocolViolation;
    }

    @Test
    void noLayer3OctetsEverBreakTheDecoder() {
        Random random = new Random(2005);
        int[] read = new int[2];
        for (Examples.Example example : Examples.all()) {
            for (int round = 0; round < ROUNDS; round++) {
                byte[] spoilt = spoil(example.octets(), random);
                Direction direction = random.nextInt(8) == 0 ? other(example.direction()) : example.direction();
                read[decodes(spoilt, octets -> Layer3Codec.decode(octets, direction)) ? 1 : 0]++;
            }
        }
        assertTrue(read[0] > 20_000 && read[1] > 20_000, () -> "both happen often: " + Arrays.toString(read));
    }

    @Test
    void whateverIsReadCanBeWrittenAndReadAgain() throws ProtocolViolation {
        Random random = new Random(3003);
        for (Examples.Example example : Examples.all()) {
            for (int round = 0; round < ROUNDS / 10; round++) {
                byte[] spoilt = spoil(example.octets(), random);
                Layer3Message message;
                try {
                    message = Layer3Codec.decode(spoilt, example.direction());
                } catch (ProtocolViolation violation) {
                    continue;
                }
                if (namesNobody(message, example.direction())) {
                    continue;
                }
                byte[] written = Layer3Codec.encode(message, example.direction(), 0);
                assertEquals(
                        message,
                        Layer3Codec.decode(written, example.direction()),
                        () -> OctetString.of(spoilt).toString());
            }
        }
    }

    /** A call to a number that could not be read: it is understood, but the suite never writes it. */
    private static boolean namesNobody(Layer3Message message, Direction direction) {
        return direction == Direction.UPLINK
                && message instanceof CallControl.Setup setup
                && setup.called().isEmpty();
    }

    @Test
    void everyViolationCanBeAnswered() {
        Random random = new Random(24008);
        for (Examples.Example example : Examples.all()) {
            for (int round = 0; round < ROUNDS / 10; round++) {
                byte[] spoilt = spoil(example.octets(), random);
                try {
                    Layer3Codec.decode(spoilt, example.direction());
                } catch (ProtocolViolation violation) {
                    for (Layer3Message answer : ProtocolErrorAnswers.to(violation, 10)) {
                        assertDoesNotThrow(() -> Layer3Codec.encode(answer, other(example.direction()), 0));
                    }
                }
            }
        }
    }

    @Test
    void noFrameEverBreaksTheOtherDecoders() {
        Random random = new Random(48058);
        for (RslMessageTest.Example example : RslMessageTest.examples()) {
            for (int round = 0; round < ROUNDS; round++) {
                decodes(spoil(OctetString.ofHex(example.hex()).toArray(), random), RslMessage::decode);
            }
        }
        for (CcmCodecTest.Example example : CcmCodecTest.examples()) {
            for (int round = 0; round < ROUNDS; round++) {
                decodes(spoil(OctetString.ofHex(example.hex()).toArray(), random), CcmCodec::decode);
            }
        }
        byte[] speech = new RtpPacket(RtpPacket.GSM_FULL_RATE, 1, 2, 3, new byte[33]).encode();
        for (int round = 0; round < ROUNDS; round++) {
            decodes(spoil(speech, random), RtpPacket::decode);
        }
    }

    private static boolean decodes(byte[] octets, Decoder decoder) {
        try {
            assertTrue(decoder.decode(octets) != null);
            return true;
        } catch (ProtocolViolation violation) {
            assertTrue(!violation.getMessage().isEmpty());
            return false;
        } catch (RuntimeException wrong) {
            throw new AssertionError(OctetString.of(octets) + " gave " + wrong, wrong);
        }
    }

    /** One to three of: an octet changed, a bit turned, an end cut off, octets put in, added or taken out. */
    static byte[] spoil(byte[] octets, Random random) {
        byte[] spoilt = octets.clone();
        for (int i = random.nextInt(3); i >= 0; i--) {
            int place = spoilt.length == 0 ? 0 : random.nextInt(spoilt.length);
            switch (random.nextInt(5)) {
                case 0 -> set(spoilt, place, random.nextInt(256));
                case 1 -> set(spoilt, place, spoilt.length == 0 ? 0 : spoilt[place] ^ 1 << random.nextInt(8));
                case 2 -> spoilt = Arrays.copyOf(spoilt, place);
                case 3 -> spoilt = joined(spoilt, place, randomOctets(random), place);
                default -> spoilt = joined(spoilt, place, new byte[0], Math.min(spoilt.length, place + 1));
            }
        }
        return spoilt;
    }

    private static void set(byte[] octets, int place, int value) {
        if (place < octets.length) {
            octets[place] = (byte) value;
        }
    }

    private static byte[] randomOctets(Random random) {
        byte[] octets = new byte[1 + random.nextInt(random.nextInt(20) == 0 ? 300 : 4)];
        random.nextBytes(octets);
        return octets;
    }

    private static byte[] joined(byte[] octets, int to, byte[] middle, int from) {
        List<byte[]> parts = new ArrayList<>();
        parts.add(Arrays.copyOf(octets, to));
        parts.add(middle);
        parts.add(Arrays.copyOfRange(octets, from, octets.length));
        OctetWriter out = new OctetWriter();
        parts.forEach(out::bytes);
        return out.toArray();
    }

    private static Direction other(Direction direction) {
        return direction == Direction.UPLINK ? Direction.DOWNLINK : Direction.UPLINK;
    }
}
