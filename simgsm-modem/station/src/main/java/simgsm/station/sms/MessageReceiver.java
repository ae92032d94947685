package simgsm.station.sms;

import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.Reassembler;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.state.StateMachine;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationEvent.ShortMessageReceived;
import simgsm.station.context.StationTimer;
import simgsm.station.sms.IncomingMessageTable.IncomingMessageAction;
import simgsm.station.sms.IncomingMessageTable.IncomingMessageEvent;
import simgsm.station.sms.IncomingMessageTable.IncomingMessageState;
import simgsm.timer.BoundedMap;

/** Receives the network's deliveries; runs by {@link IncomingMessageTable}. */
final class MessageReceiver {
    private static final int MAX_RETRANSMISSIONS = 3;
    private static final int MAX_REFUSED = 20;

    private final StationContext context;
    private final DeliveryReports reports;
    private final StateMachine<IncomingMessageState, IncomingMessageEvent, IncomingMessageAction> machine;
    private final Reassembler reassembler = new Reassembler();
    private final DuplicateFilter duplicates = new DuplicateFilter();
    /** The CP-DATA being answered; null before the first. */
    private CpData received;

    private CpData answer;
    private OctetString unconfirmed;
    private int retransmissions;
    private boolean memoryFull;
    private boolean answersLater;
    /** The text that the user has still to take; null without one. */
    private Held held;
    /** Texts that the user has refused for now: their earlier parts do not come again. */
    private final Map<OctetString, ShortMessageReceived> refused = new BoundedMap<>(MAX_REFUSED);

    /** True while the network waits for RP-SMMA after a refusal. */
    private boolean networkWaits;

    /** @param tpdu of the last part */
    private record Held(OctetString tpdu, int reference, ShortMessageReceived text) {}

    MessageReceiver(StationContext context, DeliveryReports reports) {
        this.context = context;
        this.reports = reports;
        machine = new StateMachine<>(
                IncomingMessageTable.TABLE, context.identity().number(), this::perform);
    }

    boolean isBusy() {
        return machine.state() != IncomingMessageState.IDLE;
    }

    /** Refuses messages from now on, except status reports and duplicates. */
    void memoryFull() {
        memoryFull = true;
    }

    /** @return true if the network waits for RP-SMMA */
    boolean memoryAvailable() {
        boolean report = memoryFull && networkWaits;
        memoryFull = false;
        networkWaits = false;
        return report;
    }

    /** From now on {@link #taken} or {@link #refused} answers each complete text. */
    void answersLater() {
        answersLater = true;
    }

    /** The user has the text. */
    void taken() {
        answer(Optional.empty());
    }

    /** The user does not take the text. */
    void refused(RpCause cause) {
        answer(Optional.of(cause));
    }

    private void answer(Optional<RpCause> refusal) {
        if (held == null) {
            return;
        }
        Held text = held;
        held = null;
        if (refusal.isPresent()) {
            duplicates.forget(text.tpdu);
            refused.put(text.tpdu, text.text);
            networkWaits |= refusal.get() == RpCause.MEMORY_CAPACITY_EXCEEDED;
        }
        if (isBusy() && answer == null) {
            RelayMessage relay = refusal.isPresent()
                    ? new RpError(text.reference, refusal.get())
                    : new RpAck(text.reference, Optional.empty());
            answer = new CpData(received.transaction().answered(), relay);
            perform(IncomingMessageAction.SEND_ANSWER);
        } else if (refusal.isEmpty()) {
            // the network has given up and delivers the text again
            duplicates.unconfirmed(text.tpdu);
        }
    }

    void arrived(CpData data) {
        boolean repeated = isBusy() && data.equals(received);
        received = data;
        machine.fire(repeated ? IncomingMessageEvent.CP_DATA_REPEATED : IncomingMessageEvent.CP_DATA);
    }

    /** CP-ACK or CP-ERROR has arrived. */
    void ended(TransactionIdentifier transaction, boolean acknowledged) {
        if (isBusy() && received.transaction().equals(transaction)) {
            machine.fire(acknowledged ? IncomingMessageEvent.CP_ACK : IncomingMessageEvent.CP_ERROR);
        }
    }

    private void tc1Expired() {
        machine.fire(
                ++retransmissions > MAX_RETRANSMISSIONS
                        ? IncomingMessageEvent.TC1_EXPIRED_FINALLY
                        : IncomingMessageEvent.TC1_EXPIRED);
    }

    void radioLost() {
        machine.fire(IncomingMessageEvent.RADIO_LOST);
    }

    void linkLost() {
        radioLost();
        duplicates.linkLost();
    }

    private void perform(IncomingMessageAction action) {
        switch (action) {
            case SEND_CP_ACK ->
                context.radio().send(new CpAck(received.transaction().answered()));
            case TAKE_MESSAGE -> takeMessage();
            case SEND_ANSWER -> {
                if (answer != null) {
                    context.radio().send(answer);
                }
            }
            case START_TC1 -> context.timers().start(StationTimer.TC1_INCOMING, this::tc1Expired);
            case STOP_TC1 -> context.timers().stop(StationTimer.TC1_INCOMING);
            case EXPECT_DUPLICATE -> {
                if (answer != null) {
                    duplicates.unconfirmed(unconfirmed);
                }
            }
        }
    }

    private void takeMessage() {
        Optional<RelayMessage> relay;
        if (received.relay() instanceof RpData relayed) {
            relay = take(relayed);
            unconfirmed = relayed.tpdu();
        } else {
            relay = Optional.of(new RpError(received.relay().reference(), RpCause.MESSAGE_NOT_COMPATIBLE));
            unconfirmed = OctetString.of(new byte[0]);
        }
        answer = relay.map(it -> new CpData(received.transaction().answered(), it))
                .orElse(null);
        retransmissions = 0;
    }

    /** Empty if the user answers. */
    private Optional<RelayMessage> take(RpData relayed) {
        try {
            OctetString comparable = DuplicateFilter.withoutMoreMessages(relayed.tpdu());
            if (held != null) {
                boolean isAgain = held.tpdu.equals(comparable);
                held = isAgain ? new Held(comparable, relayed.reference(), held.text) : held;
                networkWaits |= !isAgain;
                return isAgain
                        ? Optional.empty()
                        : Optional.of(new RpError(relayed.reference(), RpCause.MEMORY_CAPACITY_EXCEEDED));
            }
            Tpdu tpdu = TpduCodec.decode(relayed.tpdu(), Direction.DOWNLINK);
            if (memoryFull && tpdu instanceof DeliverTpdu && !duplicates.mayBeDuplicate(relayed.tpdu())) {
                networkWaits = true;
                return Optional.of(new RpError(relayed.reference(), RpCause.MEMORY_CAPACITY_EXCEEDED));
            }
            if (!duplicates.isDuplicate(relayed.tpdu())) {
                context.events().add(new StationEvent.TransferUnitReceived(relayed.tpdu()));
                Optional<ShortMessageReceived> text =
                        Optional.ofNullable(refused.remove(comparable)).or(() -> take(tpdu));
                text.ifPresent(context.events()::add);
                if (answersLater && text.isPresent()) {
                    held = new Held(comparable, relayed.reference(), text.get());
                    return Optional.empty();
                }
            }
            return Optional.of(new RpAck(relayed.reference(), Optional.empty()));
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "short message refused: {0}", e.getMessage());
            return Optional.of(new RpError(
                    relayed.reference(), RpCause.ofCode(e.statusCause().code())));
        }
    }

    /** The text that this part completes. */
    private Optional<ShortMessageReceived> take(Tpdu tpdu) {
        if (tpdu instanceof DeliverTpdu deliver) {
            String from = deliver.originator().toString();
            return reassembler
                    .accept(
                            deliver.originator(),
                            deliver.userData(),
                            context.timers().nowNanos())
                    .map(text -> new ShortMessageReceived(from, text));
        }
        if (tpdu instanceof StatusReportTpdu report) {
            reports.arrived(report);
        }
        return Optional.empty();
    }
}
