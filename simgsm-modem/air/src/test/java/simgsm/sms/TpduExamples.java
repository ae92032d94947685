package simgsm.sms;

import java.time.OffsetDateTime;
import java.util.List;
import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;

/** Transfer units with their octets. */
final class TpduExamples {
    record Example(Tpdu tpdu, Direction direction, String hex) {}

    static final SmsAddress ALICE = SmsAddress.of(Msisdn.parse("+491700000001"));
    static final SmsAddress BOB = SmsAddress.of(Msisdn.parse("+491700000002"));
    static final Timestamp NOON = Timestamp.of(OffsetDateTime.parse("2026-11-21T12:00:00+01:00"));

    static final List<Example> ALL = List.of(
            new Example(
                    new SubmitTpdu(
                            false,
                            true,
                            false,
                            1,
                            BOB,
                            0,
                            Optional.of(new ValidityPeriod.Relative(0xa7)),
                            UserData.of("hello")),
                    Direction.UPLINK,
                    "31010c919471000000200000a705e8329bfd06"),
            new Example(
                    new SubmitTpdu(true, false, true, 255, BOB, 0, Optional.empty(), UserData.of("")),
                    Direction.UPLINK,
                    "85ff0c91947100000020000000"),
            new Example(
                    new SubmitTpdu(
                            false,
                            false,
                            false,
                            7,
                            new SmsAddress(0, 1, "*100#"),
                            0x41,
                            Optional.of(new ValidityPeriod.Absolute(NOON)),
                            UserData.of("á")),
                    Direction.UPLINK,
                    "190705811a00fb41086211122100004002" + "00e1"),
            new Example(
                    new SubmitTpdu(
                            false,
                            false,
                            false,
                            8,
                            BOB,
                            0,
                            Optional.of(new ValidityPeriod.Enhanced(OctetString.ofHex("023c0000000000"))),
                            new UserData(true, DataCodingScheme.OCTETS, 7, OctetString.ofHex("0500032a020141"))),
                    Direction.UPLINK,
                    "49080c919471000000200004" + "023c0000000000" + "07" + "0500032a020141"),
            new Example(
                    new DeliverTpdu(false, false, false, ALICE, 0, NOON, UserData.of("hello")),
                    Direction.DOWNLINK,
                    "040c9194710000001000006211122100004005e8329bfd06"),
            new Example(
                    new DeliverTpdu(true, true, true, SmsAddress.ofLetters("SimGSM"), 0, NOON, UserData.of("hello")),
                    Direction.DOWNLINK,
                    "a00bd0" + "d374fb386d02" + "0000" + "62111221000040" + "05e8329bfd06"),
            new Example(
                    new StatusReportTpdu(false, 1, BOB, NOON, NOON, DeliveryStatus.VALIDITY_EXPIRED),
                    Direction.DOWNLINK,
                    "06010c91947100000020" + "62111221000040" + "62111221000040" + "46"),
            new Example(
                    new StatusReportTpdu(true, 2, BOB, NOON, NOON, DeliveryStatus.DELIVERED),
                    Direction.DOWNLINK,
                    "02020c91947100000020" + "62111221000040" + "62111221000040" + "00"));

    private TpduExamples() {}
}
