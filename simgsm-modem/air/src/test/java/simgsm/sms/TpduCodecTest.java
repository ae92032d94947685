package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.air.Direction;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.sms.TpduExamples.Example;
import simgsm.trace.TpduText;

class TpduCodecTest {
    static List<Example> examples() {
        return TpduExamples.ALL;
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyUnitIsWrittenAsTheStandardShowsIt(Example example) {
        assertEquals(example.hex(), TpduCodec.encode(example.tpdu()).toString());
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyUnitIsReadBack(Example example) throws ProtocolViolation {
        assertEquals(example.tpdu(), TpduCodec.decode(OctetString.ofHex(example.hex()), example.direction()));
    }

    @Test
    void noUnitIsForgotten() {
        Set<Class<?>> shown =
                examples().stream().map(each -> each.tpdu().getClass()).collect(Collectors.toSet());

        assertEquals(Set.of(Tpdu.class.getPermittedSubclasses()), shown);
    }

    @ParameterizedTest
    @CsvSource({
        "UPLINK, '', 96",
        "UPLINK, 31, 96",
        "UPLINK, 3101, 96",
        "UPLINK, 31010c9194710000, 96",
        "UPLINK, 3101159194710000002000000000000000a705e8329bfd06, 96",
        "UPLINK, 31010b919471000000200000a705e8329bfd06, 96",
        "UPLINK, 31010c919471000000f00000a705e8329bfd06, 96",
        "UPLINK, 31010c919471000000200000a705e8329bfd, 96",
        "UPLINK, 31010c919471000000200000a7ff, 96",
        "UPLINK, 71010c919471000000200004a7020500, 96",
        "UPLINK, 71010c919471000000200004a700, 96",
        "UPLINK, 39010c9194710000002000006211, 96",
        "UPLINK, 000c91, 97",
        "UPLINK, 02, 97",
        "UPLINK, 03, 97",
        "DOWNLINK, 01, 97",
        "DOWNLINK, 03, 97",
        "DOWNLINK, 040c919471000000100000621112210000, 96",
        "DOWNLINK, 06010c91947100000020621112210000406211122100004, 96"
    })
    void brokenUnitsAreRefusedWithTheirCause(Direction direction, String hex, int cause) {
        OctetString octets = OctetString.ofHex(hex.substring(0, hex.length() & ~1));

        assertEquals(
                cause,
                assertThrows(ProtocolViolation.class, () -> TpduCodec.decode(octets, direction))
                        .statusCause()
                        .code());
    }

    @Test
    void octetsBehindTheUserDataAreNoHarm() throws ProtocolViolation {
        Example example = TpduExamples.ALL.get(0);

        assertEquals(example.tpdu(), TpduCodec.decode(OctetString.ofHex(example.hex() + "ffff"), example.direction()));
    }

    @Test
    void noOctetsEverBreakTheDecoder() {
        Random random = new Random(23040);
        int read = 0;
        for (Example example : TpduExamples.ALL) {
            for (int round = 0; round < 5000; round++) {
                byte[] octets = OctetString.ofHex(example.hex()).toArray();
                for (int i = random.nextInt(3); i >= 0; i--) {
                    octets[random.nextInt(octets.length)] = (byte) random.nextInt(256);
                }
                OctetString spoilt = OctetString.of(Arrays.copyOf(octets, random.nextInt(octets.length + 4)));
                read += decodes(spoilt, example.direction()) ? 1 : 0;
            }
        }
        int sound = read;
        assertTrue(sound > 1000, () -> sound + " were still sound");
    }

    private static boolean decodes(OctetString octets, Direction direction) {
        try {
            Tpdu tpdu = TpduCodec.decode(octets, direction);
            assertTrue(!TpduText.of(tpdu, Locale.ROOT).isEmpty());
            assertEquals(tpdu, TpduCodec.decode(TpduCodec.encode(tpdu), direction), octets::toString);
            return true;
        } catch (ProtocolViolation violation) {
            return false;
        } catch (RuntimeException wrong) {
            throw new AssertionError(octets + " gave " + wrong, wrong);
        }
    }

    @Test
    void anAddressIsANumberOrAName() {
        assertEquals(
                Optional.of(new Msisdn("5550100")),
                SmsAddress.of(new Msisdn("5550100")).number());
        assertEquals(Optional.empty(), SmsAddress.ofLetters("Robot").number());
        assertEquals(Optional.empty(), new SmsAddress(0, 1, "*100#").number());
        assertEquals(Optional.empty(), new SmsAddress(0, 1, "").number());
    }

    @Test
    void nonsenseIsNoAddress() {
        assertThrows(IllegalArgumentException.class, () -> SmsAddress.ofLetters("twelve chars"));
        assertThrows(IllegalArgumentException.class, () -> SmsAddress.ofLetters("€€€€€€"));
        assertThrows(IllegalArgumentException.class, () -> SmsAddress.ofLetters("移动"));
        assertThrows(IllegalArgumentException.class, () -> new SmsAddress(1, 1, "12x"));
        assertThrows(IllegalArgumentException.class, () -> new SmsAddress(1, 1, "1".repeat(21)));
        assertThrows(IllegalArgumentException.class, () -> new SmsAddress(8, 1, "1"));
    }

    @ParameterizedTest
    @CsvSource({
        "0x00, true, false, delivered",
        "0x46, false, false, validity period expired",
        "0x30, false, true, still trying",
        "0x5f, false, false, 'given up, permanent error'",
        "0x60, false, false, 'given up, temporary error'",
        "0x1f, true, false, completed"
    })
    void aDeliveryStatusHasWords(String octet, boolean delivered, boolean pending, String title) {
        int status = Integer.decode(octet);

        assertEquals(delivered, DeliveryStatus.isDelivered(status));
        assertEquals(pending, DeliveryStatus.isPending(status));
        assertEquals(title, DeliveryStatus.title(status));
    }
}
