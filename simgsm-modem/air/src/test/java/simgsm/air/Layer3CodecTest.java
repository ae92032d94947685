package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.air.Examples.Example;
import simgsm.octets.OctetString;

class Layer3CodecTest {
    static List<Example> examples() {
        return Examples.all();
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyMessageIsWrittenAsTheStandardShowsIt(Example example) {
        byte[] octets = Layer3Codec.encode(example.message(), example.direction(), example.sendSequence());

        assertEquals(example.hex(), OctetString.of(octets).toString());
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyMessageIsReadBack(Example example) throws ProtocolViolation {
        assertEquals(example.message(), Layer3Codec.decode(example.octets(), example.direction()));
    }

    @Test
    void noMessageKindIsForgottenInTheExamples() {
        Set<Class<?>> shown = Examples.all().stream()
                .flatMap(example -> example.message() instanceof ShortMessageControl.CpData data
                        ? List.<Object>of(data, data.relay()).stream()
                        : List.<Object>of(example.message()).stream())
                .map(Object::getClass)
                .collect(Collectors.toSet());

        for (Class<?> kind : List.of(
                MobilityManagement.class,
                CallControl.class,
                RadioResource.class,
                ShortMessageControl.class,
                SupplementaryService.class,
                RelayMessage.class)) {
            for (Class<?> message : kind.getPermittedSubclasses()) {
                assertTrue(shown.contains(message), message + " has an example");
            }
        }
        assertEquals(Layer3Type.values().length + RelayMessage.class.getPermittedSubclasses().length, shown.size());
    }

    @Test
    void aSetupReadsOverOptionalElementsThatItDoesNotKnow() throws ProtocolViolation {
        assertEquals(
                new CallControl.Setup(Examples.ours(0), Optional.empty(), Optional.of(new Msisdn("123"))),
                up("0305" + "04066004020005815e" + "038121f3" + "150101" + "a1" + "7f03010203"));
    }

    @Test
    void signalInASetupIsOneOctetWithoutLength() throws ProtocolViolation {
        assertEquals(
                new CallControl.Setup(Examples.ours(0), Optional.of(new Msisdn("12")), Optional.empty()),
                down("03050401a034015c028121"));
    }

    @Test
    void theSendSequenceToggleIsReadAndMasked() throws ProtocolViolation {
        byte[] octets = Layer3Codec.encode(new CallControl.Alerting(Examples.ours(0)), Direction.UPLINK, 1);

        assertEquals(1, Layer3Codec.sendSequence(octets));
        assertEquals(new CallControl.Alerting(Examples.ours(0)), Layer3Codec.decode(octets, Direction.UPLINK));
        assertEquals(-1, Layer3Codec.sendSequence(OctetString.ofHex("060d00").toArray()));
        assertEquals(-1, Layer3Codec.sendSequence(OctetString.ofHex("0904").toArray()));
    }

    @Test
    void networkMessagesNeverCarryTheToggle() {
        byte[] octets = Layer3Codec.encode(new CallControl.Alerting(Examples.theirs(0)), Direction.DOWNLINK, 1);

        assertEquals(0x01, octets[1]);
    }

    @Test
    void aMessageIsNotSentTheWayThatItNeverGoes() {
        assertThrows(
                IllegalArgumentException.class,
                () -> Layer3Codec.encode(new CallControl.CallProceeding(Examples.ours(0)), Direction.UPLINK, 0));
    }

    @Test
    void aNationalNetworkNameTravelsAsUcs2() throws ProtocolViolation {
        MobilityManagement.MmInformation name = new MobilityManagement.MmInformation("Señal ñ € 移动");

        assertEquals(name, Layer3Codec.decode(Layer3Codec.encode(name, Direction.DOWNLINK, 0), Direction.DOWNLINK));
    }

    private static Layer3Message up(String hex) throws ProtocolViolation {
        return Layer3Codec.decode(OctetString.ofHex(hex).toArray(), Direction.UPLINK);
    }

    private static Layer3Message down(String hex) throws ProtocolViolation {
        return Layer3Codec.decode(OctetString.ofHex(hex).toArray(), Direction.DOWNLINK);
    }

    /** JDK 17.0.15 read 00000000 after some 50 000 calls, so the network refused every card: see {@code Octets.range}. */
    @Test
    void anAuthenticationResponseReadsTheSameInCompiledCode() throws ProtocolViolation {
        for (int call = 1; call <= 300_000; call++) {
            byte[] message = {5, 0x14, 1, (byte) (call >> 16), (byte) (call >> 8), (byte) call};
            MobilityManagement.AuthenticationResponse response =
                    (MobilityManagement.AuthenticationResponse) Layer3Codec.decode(message, Direction.UPLINK);
            assertEquals(0x1000000 | call, Integer.parseInt(response.response().toString(), 16), "call " + call);
        }
    }
}
