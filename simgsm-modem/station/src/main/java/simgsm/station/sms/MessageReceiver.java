package simgsm.station.sms;

import java.lang.System.Logger.Level;
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
import simgsm.station.context.StationTimer;
import simgsm.station.sms.IncomingMessageTable.IncomingMessageAction;
import simgsm.station.sms.IncomingMessageTable.IncomingMessageEvent;
import simgsm.station.sms.IncomingMessageTable.IncomingMessageState;

/** Receives the network's deliveries; runs by {@link IncomingMessageTable}. */
final class MessageReceiver {
    private static final int MAX_RETRANSMISSIONS = 3;

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
    /** True while the network waits for RP-SMMA after a refusal. */
    private boolean networkWaits;

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
            case SEND_ANSWER -> context.radio().send(answer);
            case START_TC1 -> context.timers().start(StationTimer.TC1_INCOMING, this::tc1Expired);
            case STOP_TC1 -> context.timers().stop(StationTimer.TC1_INCOMING);
            case EXPECT_DUPLICATE -> duplicates.unconfirmed(unconfirmed);
        }
    }

    private void takeMessage() {
        RelayMessage relay;
        if (received.relay() instanceof RpData relayed) {
            relay = take(relayed);
            unconfirmed = relayed.tpdu();
        } else {
            relay = new RpError(received.relay().reference(), RpCause.MESSAGE_NOT_COMPATIBLE);
            unconfirmed = OctetString.of(new byte[0]);
        }
        answer = new CpData(received.transaction().answered(), relay);
        retransmissions = 0;
    }

    private RelayMessage take(RpData relayed) {
        try {
            Tpdu tpdu = TpduCodec.decode(relayed.tpdu(), Direction.DOWNLINK);
            if (memoryFull && tpdu instanceof DeliverTpdu && !duplicates.mayBeDuplicate(relayed.tpdu())) {
                networkWaits = true;
                return new RpError(relayed.reference(), RpCause.MEMORY_CAPACITY_EXCEEDED);
            }
            if (!duplicates.isDuplicate(relayed.tpdu())) {
                context.events().add(new StationEvent.TransferUnitReceived(relayed.tpdu()));
                take(tpdu);
            }
            return new RpAck(relayed.reference(), Optional.empty());
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "short message refused: {0}", e.getMessage());
            return new RpError(
                    relayed.reference(), RpCause.ofCode(e.statusCause().code()));
        }
    }

    private void take(Tpdu tpdu) {
        if (tpdu instanceof DeliverTpdu deliver) {
            String from = deliver.originator().toString();
            reassembler
                    .accept(
                            deliver.originator(),
                            deliver.userData(),
                            context.timers().nowNanos())
                    .ifPresent(text -> context.events().add(new StationEvent.ShortMessageReceived(from, text)));
        } else if (tpdu instanceof StatusReportTpdu report) {
            reports.arrived(report);
        }
    }
}
