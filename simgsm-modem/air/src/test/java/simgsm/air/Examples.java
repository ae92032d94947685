package simgsm.air;

import java.time.OffsetDateTime;
import java.util.List;
import java.util.Optional;
import simgsm.air.CallControl.Alerting;
import simgsm.air.CallControl.CallConfirmed;
import simgsm.air.CallControl.CallProceeding;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.EmergencySetup;
import simgsm.air.CallControl.Hold;
import simgsm.air.CallControl.HoldAcknowledge;
import simgsm.air.CallControl.HoldReject;
import simgsm.air.CallControl.Progress;
import simgsm.air.CallControl.Release;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Retrieve;
import simgsm.air.CallControl.RetrieveAcknowledge;
import simgsm.air.CallControl.RetrieveReject;
import simgsm.air.CallControl.Setup;
import simgsm.air.CallControl.StartDtmf;
import simgsm.air.CallControl.StartDtmfAcknowledge;
import simgsm.air.CallControl.StartDtmfReject;
import simgsm.air.CallControl.Status;
import simgsm.air.CallControl.StatusEnquiry;
import simgsm.air.CallControl.StopDtmf;
import simgsm.air.CallControl.StopDtmfAcknowledge;
import simgsm.air.MeasurementResults.Neighbour;
import simgsm.air.MobilityManagement.AuthenticationFailure;
import simgsm.air.MobilityManagement.AuthenticationReject;
import simgsm.air.MobilityManagement.AuthenticationRequest;
import simgsm.air.MobilityManagement.AuthenticationResponse;
import simgsm.air.MobilityManagement.CmServiceAbort;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.IdentityRequest;
import simgsm.air.MobilityManagement.IdentityResponse;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.LocationUpdatingType;
import simgsm.air.MobilityManagement.MmAbort;
import simgsm.air.MobilityManagement.MmInformation;
import simgsm.air.MobilityManagement.MmStatus;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.MobilityManagement.TmsiReallocationCommand;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.RadioResource.*;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RelayMessage.RpSmma;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.octets.OctetString;

/** One message of every kind with its octets, each read and named by Wireshark without a complaint. */
public final class Examples {
    /** @param sendSequence N(SD) that the octets carry; 0 where there is none */
    public record Example(Layer3Message message, Direction direction, int sendSequence, String hex) {
        byte[] octets() {
            return OctetString.ofHex(hex).toArray();
        }
    }

    private static final Direction UP = Direction.UPLINK;
    private static final Direction DOWN = Direction.DOWNLINK;

    static final LocationArea AREA = new LocationArea("262", "42", 1);
    public static final Imsi IMSI = new Imsi("262420000000017");
    static final Imei IMEI = new Imei("490154203237518");
    static final Tmsi TMSI = new Tmsi(0xf41234ab);
    public static final Msisdn SERVICE_CENTER = Msisdn.parse("+491700000000");

    static final List<Example> MOBILITY_MANAGEMENT = List.of(
            up(
                    new LocationUpdatingRequest(LocationUpdatingType.IMSI_ATTACH, 7, AREA, IMSI),
                    "05087262f224000133082926240000000071"),
            down(new IdentityRequest(MobileIdentity.Type.IMEI), "051802"),
            up(new IdentityResponse(IMEI), "0519084a09512430325701"),
            down(
                    new AuthenticationRequest(
                            0,
                            OctetString.ofHex("23553cbe9637a89d218ae64dae47bf35"),
                            Optional.of(OctetString.ofHex("55f328b43577b9b94a9ffac354dfafb3"))),
                    "05120023553cbe9637a89d218ae64dae47bf35201055f328b43577b9b94a9ffac354dfafb3"),
            down(
                    new AuthenticationRequest(
                            1, OctetString.ofHex("23553cbe9637a89d218ae64dae47bf35"), Optional.empty()),
                    "05120123553cbe9637a89d218ae64dae47bf35"),
            up(new AuthenticationResponse(OctetString.ofHex("a54211d5e3ba50bf")), "0514a54211d52104e3ba50bf"),
            up(new AuthenticationResponse(OctetString.ofHex("46f8416a")), "051446f8416a"),
            down(new AuthenticationReject(), "0511"),
            up(new AuthenticationFailure(RejectCause.MAC_FAILURE, Optional.empty()), "051c14"),
            up(
                    new AuthenticationFailure(
                            RejectCause.SYNCH_FAILURE, Optional.of(OctetString.ofHex("451e8beca43b01cfaf9ec4e871e9"))),
                    "051c15220e451e8beca43b01cfaf9ec4e871e9"),
            down(new LocationUpdatingAccept(AREA, Optional.of(new Tmsi(0xf41234ab))), "050262f22400011705f4f41234ab"),
            down(new LocationUpdatingAccept(AREA, Optional.of(new Tmsi(0x1234abcd))), "050262f22400011705f41234abcd"),
            down(new LocationUpdatingAccept(AREA, Optional.empty()), "050262f2240001"),
            down(new LocationUpdatingReject(RejectCause.IMSI_UNKNOWN_IN_HLR), "050402"),
            new Example(new TmsiReallocationComplete(), UP, 1, "055b"),
            down(new TmsiReallocationCommand(LocationArea.TEST, new Tmsi(0x1234abcd)), "051a00f110000105f41234abcd"),
            down(new MmAbort(RejectCause.ILLEGAL_ME), "052906"),
            down(new MmInformation("SimGSM"), "0532430786d374fb386d02"),
            down(
                    new MmInformation("SimGSM", Optional.of(OffsetDateTime.parse("2026-11-21T12:00:30+01:00"))),
                    "0532430786d374fb386d024762111211000340"),
            down(
                    new MmInformation("SimGSM", Optional.of(OffsetDateTime.parse("2026-11-21T22:00:30-03:30"))),
                    "0532430786d374fb386d024762112210030349"),
            up(
                    new CmServiceRequest(ServiceType.MOBILE_ORIGINATED_CALL, 7, new Tmsi(0x1234abcd)),
                    "0524710333198205f41234abcd"),
            down(new CmServiceAccept(), "0521"),
            new Example(new CmServiceAbort(), UP, 1, "0563"),
            down(new CmServiceReject(RejectCause.CONGESTION), "052216"),
            up(new ImsiDetachIndication(new Tmsi(0x1234abcd)), "05013305f41234abcd"),
            up(new MmStatus(RejectCause.MESSAGE_TYPE_NON_EXISTENT), "053161"),
            down(new MmStatus(RejectCause.INVALID_MANDATORY_INFORMATION), "053160"));

    static final List<Example> CALL_CONTROL = List.of(
            up(
                    new Setup(ours(0), Optional.empty(), Optional.of(Msisdn.parse("+491700000002"))),
                    "030504066004020005815e0791947100000020"),
            down(
                    new Setup(ours(0), Optional.of(Msisdn.parse("+491700000001")), Optional.empty()),
                    "03050401a05c081183947100000010"),
            down(
                    new Setup(
                            ours(1),
                            Optional.of(Msisdn.parse("+491700000001")),
                            Optional.of(Msisdn.parse("+491700000002"))),
                    "13050401a05c0811839471000000105e0791947100000020"),
            up(
                    new Setup(ours(0), Optional.empty(), Optional.of(new Msisdn("5550200"))),
                    "030504066004020005815e0581550502f0"),
            down(
                    new Setup(ours(0), Optional.of(new Msisdn("5550100")), Optional.empty()),
                    "03050401a05c060183550501f0"),
            down(new Connect(theirs(0), Optional.of(new Msisdn("5550100"))), "83074c060183550501f0"),
            up(
                    new Setup(
                            ours(0),
                            Optional.empty(),
                            Optional.empty(),
                            Optional.of(new Msisdn("5550200")),
                            Optional.empty(),
                            true),
                    "030504066004020005815e0581550502f0a2"),
            down(
                    new Setup(
                            ours(0),
                            Optional.empty(),
                            Optional.of(new Msisdn("5550100")),
                            Optional.empty(),
                            Optional.of(new Msisdn("5550101")),
                            false),
                    "03050401a05c060183550501f074060183550501f1"),
            up(new EmergencySetup(ours(0)), "030e0406600402000581"),
            up(new CallConfirmed(theirs(0)), "8308"),
            down(new CallProceeding(theirs(0)), "8302"),
            down(new Progress(theirs(0)), "830302e288"),
            down(new Alerting(theirs(0)), "8301"),
            down(new Alerting(theirs(0), true), "83011e02e288"),
            down(new Disconnect(theirs(0), Cause.USER_BUSY, CauseLocation.USER, false), "832502e091"),
            down(
                    new Disconnect(theirs(0), Cause.USER_BUSY, CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, true),
                    "832502e2911e02e288"),
            new Example(new Alerting(theirs(0)), UP, 1, "8341"),
            up(new Connect(theirs(0)), "8307"),
            down(new ConnectAcknowledge(ours(0)), "030f"),
            up(new StartDtmf(ours(0), '5'), "03352c35"),
            down(new StartDtmfAcknowledge(theirs(0), '5'), "83362c35"),
            down(new StartDtmfReject(theirs(0), Cause.SERVICE_NOT_AVAILABLE), "833702e2bf"),
            up(new StopDtmf(ours(0)), "0331"),
            up(new Hold(theirs(0)), "8318"),
            down(new HoldAcknowledge(ours(0)), "0319"),
            down(new HoldReject(ours(0), Cause.MESSAGE_NOT_COMPATIBLE_WITH_CALL_STATE), "031a02e2e5"),
            up(new Retrieve(theirs(0)), "831c"),
            down(new RetrieveAcknowledge(ours(0)), "031d"),
            down(
                    new CallControl.Facility(ours(0), OctetString.ofHex("a10e02010102011030068101428f0101")),
                    "033a10a10e02010102011030068101428f0101"),
            down(new RetrieveReject(ours(0), Cause.MESSAGE_NOT_COMPATIBLE_WITH_CALL_STATE), "031e02e2e5"),
            down(new StopDtmfAcknowledge(theirs(0)), "8332"),
            up(new Disconnect(ours(0), Cause.NORMAL_CALL_CLEARING), "032502e090"),
            down(
                    new Release(
                            theirs(0),
                            Optional.of(Cause.NORMAL_CALL_CLEARING),
                            Optional.of(CauseLocation.TRANSIT_NETWORK)),
                    "832d0802e390"),
            down(new ReleaseComplete(theirs(0), Optional.of(Cause.USER_BUSY)), "832a0802e091"),
            down(new Release(theirs(0), Optional.empty()), "832d"),
            up(new ReleaseComplete(ours(0), Optional.of(Cause.NORMAL_CALL_CLEARING)), "032a0802e090"),
            new Example(new ReleaseComplete(ours(0), Optional.empty()), UP, 1, "036a"),
            up(new StatusEnquiry(ours(0)), "0334"),
            down(new Status(theirs(0), Cause.RESPONSE_TO_STATUS_ENQUIRY, 10), "833d02e29eca"));

    private static final ChannelDescription TRAFFIC =
            new ChannelDescription(ChannelNumber.of(ChannelNumber.Kind.TCH_F, 2), 2, 100);

    static final List<Example> RADIO_RESOURCE = List.of(
            up(new PagingResponse(7, new Tmsi(0x1234abcd)), "0627070333198205f41234abcd"),
            down(new ChannelRelease(0), "060d00"),
            up(new RrStatus(97), "061261"),
            down(new CipheringModeCommand(CipherAlgorithm.A5_1, 1), "063511"),
            down(new CipheringModeCommand(CipherAlgorithm.A5_0, 0), "063500"),
            down(new CipheringModeCommand(CipherAlgorithm.A5_3, 0), "063505"),
            up(new CipheringModeComplete(Optional.empty()), "0632"),
            up(
                    new CipheringModeComplete(Optional.of(Imeisv.of(new Imei("001017500000010")))),
                    "063217090310105700000001f1"),
            down(new ClassmarkEnquiry(), "0613"),
            up(new ClassmarkChange(), "0616033319822003601400"),
            down(new AssignmentCommand(TRAFFIC, 15, RadioResource.SPEECH_FULL_RATE), "062e0a40640f6301"),
            up(new AssignmentComplete(0), "062900"),
            down(new ChannelModeModify(TRAFFIC, RadioResource.SPEECH_FULL_RATE), "06100a406401"),
            up(new ChannelModeModifyAcknowledge(TRAFFIC, RadioResource.SIGNALLING_ONLY), "06170a406400"),
            up(new AssignmentFailure(0x6f), "062f6f"),
            down(
                    new HandoverCommand(
                            new CellDescription(11, 110),
                            new ChannelDescription(ChannelNumber.of(ChannelNumber.Kind.TCH_F, 1), 3, 110),
                            1,
                            14,
                            Optional.of(RadioResource.SPEECH_FULL_RATE)),
                    "062b0b6e09606e010e6301"),
            up(new HandoverComplete(0), "062c00"),
            up(new HandoverFailure(0x6f), "06286f"),
            down(new PhysicalInformation(5), "062d05"),
            up(
                    new MeasurementReport(
                            MeasurementResults.of(50, 1, List.of(new Neighbour(30, 0, 11), new Neighbour(20, 3, 10)))),
                    "06153232129e016a0ca00000000000000000"));

    static final List<Example> SHORT_MESSAGES = List.of(
            up(
                    new CpData(
                            ours(0),
                            new RpData(1, SERVICE_CENTER, OctetString.ofHex("31010c919471000000200000a705e8329bfd06"))),
                    "09011f00010007919471000000001331010c919471000000200000a705e8329bfd06"),
            down(new CpAck(theirs(0)), "8904"),
            down(new CpData(theirs(0), new RpAck(1, Optional.empty())), "8901020301"),
            up(new CpAck(ours(0)), "0904"),
            down(
                    new CpData(
                            ours(2),
                            new RpData(
                                    7,
                                    SERVICE_CENTER,
                                    OctetString.ofHex("040c9194710000001000006211122100004005e8329bfd06"))),
                    "290124010707919471000000000018040c9194710000001000006211122100004005e8329bfd06"),
            up(new CpData(theirs(2), new RpAck(7, Optional.of(OctetString.ofHex("0000")))), "a90106020741020000"),
            up(new CpData(theirs(2), new RpError(7, RpCause.MEMORY_CAPACITY_EXCEEDED)), "a9010404070116"),
            down(new CpData(theirs(0), new RpError(3, RpCause.UNASSIGNED_NUMBER)), "89010405030101"),
            up(new CpData(ours(3), new RpSmma(9)), "3901020609"),
            down(new CpError(theirs(0), 97), "891061"));

    /** processUnstructuredSS-Request of *100#. */
    public static final OctetString USSD_REQUEST = OctetString.ofHex("a11202010102013b300a04010f0405aa180c3602");

    static final List<Example> SUPPLEMENTARY_SERVICES = List.of(
            up(
                    new SsRegister(ours(0), USSD_REQUEST, Optional.of(SsRegister.PHASE_2)),
                    "0b3b1c14a11202010102013b300a04010f0405aa180c36027f0100"),
            down(
                    new SsRegister(ours(1), USSD_REQUEST, Optional.empty()),
                    "1b3b1c14a11202010102013b300a04010f0405aa180c3602"),
            up(new SsFacility(theirs(1), OctetString.ofHex("a203020101")), "9b3a05a203020101"),
            new Example(
                    new SsFacility(ours(0), OctetString.ofHex("a306020101020124")), UP, 1, "0b7a08a306020101020124"),
            down(new SsReleaseComplete(theirs(0), OctetString.ofHex("a306020101020115")), "8b2a1c08a306020101020115"),
            down(new SsReleaseComplete(theirs(0), Cause.INVALID_TRANSACTION_IDENTIFIER), "8b2a0802e2d1"),
            up(new SsReleaseComplete(ours(0)), "0b2a"));

    private Examples() {}

    public static List<Example> all() {
        return List.of(MOBILITY_MANAGEMENT, CALL_CONTROL, RADIO_RESOURCE, SHORT_MESSAGES, SUPPLEMENTARY_SERVICES)
                .stream()
                .flatMap(List::stream)
                .toList();
    }

    public static TransactionIdentifier ours(int value) {
        return new TransactionIdentifier(value, false);
    }

    public static TransactionIdentifier theirs(int value) {
        return new TransactionIdentifier(value, true);
    }

    private static Example up(Layer3Message message, String hex) {
        return new Example(message, UP, 0, hex);
    }

    private static Example down(Layer3Message message, String hex) {
        return new Example(message, DOWN, 0, hex);
    }
}
