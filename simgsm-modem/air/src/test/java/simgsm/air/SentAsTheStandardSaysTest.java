package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Setup;
import simgsm.air.MobilityManagement.AuthenticationFailure;
import simgsm.air.MobilityManagement.IdentityResponse;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.octets.OctetString;

/** What is sent is what the standard says: for each fact its clause, what others send, how that is read, what is sent here. */
class SentAsTheStandardSaysTest {
    private static final TransactionIdentifier TI = new TransactionIdentifier(0, true);
    private static final Imei IMEI = new Imei("490154203237518");

    /**
     * One fact.
     *
     * @param others octets of another core or phone
     * @param read what they mean
     * @param ours the octets that are sent here for the same
     */
    record Row(String fact, Direction direction, String others, Layer3Message read, String ours) {
        @Override
        public String toString() {
            return fact;
        }
    }

    static List<Row> rows() {
        return Stream.concat(Stream.of(calls(), identities()).flatMap(List::stream), rejects())
                .toList();
    }

    private static List<Row> calls() {
        return List.of(
                down(
                        "24.008 10.5.4.11: osmo-msc sends its own cause as a private network's, the exchange here as a public one's",
                        "832502e181",
                        new Disconnect(TI, Cause.UNASSIGNED_NUMBER, CauseLocation.PRIVATE_NETWORK_OF_LOCAL_USER, false),
                        "832502e181"),
                down(
                        "24.008 10.5.4.11: a user's cause that the network passes on",
                        "832a0802e091",
                        new ReleaseComplete(TI, Optional.of(Cause.USER_BUSY)),
                        "832a0802e091"),
                down(
                        "24.008 10.5.4.13: connected number, screening indicator network provided",
                        "83074c060183550501f0",
                        new Connect(TI, Optional.of(new Msisdn("5550100"))),
                        "83074c060183550501f0"),
                down(
                        "24.008 10.5.4.9: calling number of a user, verified; here it is the network's",
                        "83050401a05c060181550501f0",
                        new Setup(TI, Optional.of(new Msisdn("5550100")), Optional.empty()),
                        "83050401a05c060183550501f0"),
                up(
                        "24.008 10.5.4.7: type of number unknown, as dialled",
                        "03050406600402000581" + "5e0581550502f0",
                        setup("5550200"),
                        "03050406600402000581" + "5e0581550502f0"),
                up(
                        "24.008 10.5.4.7: type of number international, dialled with a plus",
                        "03050406600402000581" + "5e0591550502f0",
                        setup("+5550200"),
                        "03050406600402000581" + "5e0591550502f0"),
                up(
                        "24.008 10.5.4.7: a number of 16 digits is none here, the network answers with cause 28",
                        "030504066004020005815e09812143658709214365",
                        new Setup(new TransactionIdentifier(0, false), Optional.empty(), Optional.empty()),
                        "03050406600402000581"),
                up(
                        "24.008 10.5.4.7: likewise one with * and #",
                        "030504066004020005815e0481a10cf0",
                        new Setup(new TransactionIdentifier(0, false), Optional.empty(), Optional.empty()),
                        "03050406600402000581"));
    }

    private static Setup setup(String called) {
        return new Setup(new TransactionIdentifier(0, false), Optional.empty(), Optional.of(Msisdn.parse(called)));
    }

    private static List<Row> identities() {
        return List.of(
                up(
                        "22.016 2: the Luhn digit is not sent",
                        "0519084a09512430325701",
                        identity(),
                        "0519084a09512430325701"),
                up("22.016 2: a phone sends it", "0519084a09512430325781", identity(), "0519084a09512430325701"),
                up(
                        "22.016 2: a phone sends another digit",
                        "0519084a09512430325751",
                        identity(),
                        "0519084a09512430325701"));
    }

    private static IdentityResponse identity() {
        return new IdentityResponse(IMEI);
    }

    /** 24.008 10.5.3.6. */
    private static Stream<Row> rejects() {
        Stream<Row> named = Stream.of(13, 15, 23, 25, 33, 34, 48, 99, 100, 101)
                .map(code -> down(
                        "24.008 10.5.3.6: reject cause " + code,
                        String.format("0504%02x", code),
                        new LocationUpdatingReject(RejectCause.ofCode(code, Direction.DOWNLINK)),
                        String.format("0504%02x", code)));
        return Stream.concat(
                named,
                Stream.of(
                        down(
                                "24.008 10.5.3.6: for the mobile an unknown cause is 34",
                                "05047f",
                                new LocationUpdatingReject(RejectCause.SERVICE_OPTION_OUT_OF_ORDER),
                                "050422"),
                        down(
                                "24.008 10.5.3.6: 48 to 63 are one cause",
                                "05043f",
                                new LocationUpdatingReject(RejectCause.RETRY_IN_NEW_CELL),
                                "050430"),
                        up(
                                "24.008 10.5.3.6: for the network an unknown cause is 111",
                                "051c7f",
                                new AuthenticationFailure(RejectCause.PROTOCOL_ERROR, Optional.empty()),
                                "051c6f")));
    }

    private static Row down(String fact, String others, Layer3Message read, String ours) {
        return new Row(fact, Direction.DOWNLINK, others, read, ours);
    }

    private static Row up(String fact, String others, Layer3Message read, String ours) {
        return new Row(fact, Direction.UPLINK, others, read, ours);
    }

    @ParameterizedTest
    @MethodSource("rows")
    void whatOthersSendIsReadAndSentAsTheStandardSays(Row row) throws ProtocolViolation {
        assertEquals(row.read, Layer3Codec.decode(OctetString.ofHex(row.others).toArray(), row.direction));
        assertEquals(
                row.ours,
                OctetString.of(Layer3Codec.encode(row.read, row.direction, 0)).toString());
    }
}
