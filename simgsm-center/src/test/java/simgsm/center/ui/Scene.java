package simgsm.center.ui;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.BroadcastView;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.LadderEntry;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.CallView;
import simgsm.center.smsc.DeliveryAttempt;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.WaitReason;
import simgsm.octets.OctetString;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.trace.MessageText;

/** Snapshots of an exchange through which a call and a message have passed. */
public final class Scene {
    public static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");
    public static final Msisdn PHONE = new Msisdn("5550100");
    public static final Msisdn ROBOT = new Msisdn("5550200");
    public static final Msisdn ABSENT = new Msisdn("5550201");

    private static final TransactionIdentifier OURS = new TransactionIdentifier(0, false);

    private Scene() {}

    public static LadderEntry up(Msisdn number, Layer3Message message) {
        return entry(number.digits(), LadderEntry.CENTER, message, Direction.UPLINK);
    }

    public static LadderEntry down(Msisdn number, Layer3Message message) {
        return entry(LadderEntry.CENTER, number.digits(), message, Direction.DOWNLINK);
    }

    private static LadderEntry entry(String from, String to, Layer3Message message, Direction direction) {
        OctetString octets = OctetString.of(Layer3Codec.encode(message, direction, 0));
        return new LadderEntry(NOON, from, to, MessageText.nameOf(message, direction), octets);
    }

    public static LadderEntry setup() {
        return up(PHONE, new CallControl.Setup(OURS, Optional.empty(), Optional.of(ROBOT)));
    }

    public static LadderEntry alerting(Msisdn number) {
        return up(number, new CallControl.Alerting(new TransactionIdentifier(0, true)));
    }

    public static LadderEntry submit(String text) {
        RelayMessage relay = new RelayMessage.RpData(
                7, new Msisdn("5550000"), TpduCodec.encode(SubmitTpdu.of(1, SmsAddress.of(ROBOT), UserData.of(text))));
        return up(PHONE, new ShortMessageControl.CpData(OURS, relay));
    }

    public static LadderEntry accept() {
        return down(PHONE, new MobilityManagement.LocationUpdatingAccept(LocationArea.TEST, Optional.empty()));
    }

    public static LadderEntry broadcast(String text) {
        OctetString page = CellBroadcast.split(text, 50, new BroadcastSerial(1, 3, 2), Optional.of("en"))
                .get(0)
                .encode();
        OctetString octets = OctetString.of(new RslMessage.SmsBroadcastCommand(page).encode());
        return new LadderEntry(NOON, LadderEntry.CENTER, PHONE.digits(), "SMS Broadcast Command", octets);
    }

    public static LadderEntry broken() {
        return new LadderEntry(NOON, PHONE.digits(), LadderEntry.CENTER, "Start DTMF", OctetString.ofHex("03352c45"));
    }

    public static List<LadderEntry> everyKind() {
        List<LadderEntry> entries = new ArrayList<>();
        entries.add(accept());
        entries.add(setup());
        entries.add(alerting(ROBOT));
        entries.add(submit("** #*#90 **"));
        entries.add(broadcast("Attention"));
        entries.add(broken());
        return entries;
    }

    public static ExchangeSnapshot empty() {
        return new ExchangeSnapshot(
                NOON,
                0,
                0,
                0,
                0,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                0,
                Optional.empty(),
                List.of(),
                List.of());
    }

    /** This number of messages between phone, centre and robot, and nothing else. */
    public static ExchangeSnapshot passing(int count) {
        List<LadderEntry> entries = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            entries.add(i % 2 == 0 ? setup() : alerting(ROBOT));
        }
        return new ExchangeSnapshot(
                NOON,
                2,
                2,
                0,
                0,
                List.of(),
                List.of(),
                List.of(),
                entries,
                count,
                Optional.empty(),
                List.of(),
                List.of());
    }

    /** This number of repeated broadcasts, and nothing else. */
    public static ExchangeSnapshot broadcasting(int count) {
        List<BroadcastView> broadcasts = new ArrayList<>();
        for (int id = 1; id <= count; id++) {
            Duration minute = Duration.ofMinutes(1);
            broadcasts.add(new BroadcastView(id, 50, Optional.empty(), 0, 1, minute, 1, OptionalInt.empty(), "Hello"));
        }
        return new ExchangeSnapshot(
                NOON,
                0,
                0,
                0,
                0,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                0,
                Optional.empty(),
                broadcasts,
                List.of());
    }

    /** A call that is active, a message that waits. */
    public static ExchangeSnapshot busy() {
        return with(Optional.of(new ExchangeSnapshot.Passing(PHONE, ROBOT.digits(), "** #*#90 **")), List.of(call()));
    }

    public static ExchangeSnapshot with(Optional<ExchangeSnapshot.Passing> latest, List<CallView> calls) {
        return new ExchangeSnapshot(
                NOON,
                2,
                2,
                1,
                50,
                List.of(
                        new ExchangeSnapshot.SubscriberRow(ROBOT, true, "001010005550200", "001017500000025"),
                        new ExchangeSnapshot.SubscriberRow(PHONE, true, "001010005550100", "001017500000017"),
                        new ExchangeSnapshot.SubscriberRow(ABSENT, false, "001010005550201", "")),
                calls,
                List.of(new ExchangeSnapshot.MessageRow("** #**20 **", waiting())),
                everyKind(),
                everyKind().size(),
                latest,
                List.of(),
                List.of());
    }

    /** A message that has been tried once in vain. */
    public static MessageHistory waiting() {
        OctetString submit = TpduCodec.encode(SubmitTpdu.of(1, SmsAddress.of(ABSENT), UserData.of("** #**20 **")));
        return new MessageHistory(
                new ShortMessage(1, PHONE, ABSENT, submit, NOON, NOON.plusSeconds(86_400)),
                MessageState.ACCEPTED,
                WaitReason.AWAITING_MEMORY,
                List.of(new DeliveryAttempt(NOON.plusSeconds(3), DeliveryOutcome.MEMORY_FULL)),
                1,
                Optional.of(NOON.plusSeconds(63)),
                Optional.empty());
    }

    public static CallView call() {
        return new CallView(PHONE, ROBOT.digits(), CallProgress.ACTIVE, 75);
    }
}
