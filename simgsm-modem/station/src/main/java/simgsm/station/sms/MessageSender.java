package simgsm.station.sms;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.sms.MessageSplitter;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.state.StateMachine;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationTimer;
import simgsm.station.mobility.ServiceRequests;
import simgsm.station.sms.OutgoingMessageTable.OutgoingMessageAction;
import simgsm.station.sms.OutgoingMessageTable.OutgoingMessageEvent;
import simgsm.station.sms.OutgoingMessageTable.OutgoingMessageState;

/** Sends queued messages, one part after the other; runs by {@link OutgoingMessageTable}. */
final class MessageSender implements ServiceRequests.ServiceUser {
    /** TP-MR and RP-MR have one octet. */
    private static final int REFERENCE_MASK = 0xff;

    private static final int TRANSACTIONS = 7;
    private static final int MAX_RETRANSMISSIONS = 3;
    /** Losses of the radio connection that make a message fail. */
    private static final int MAX_LOSSES = 3;

    private static final int CP_CONGESTION = 22;

    /** TP-MTI of a SUBMIT, and TP-RD, in the first octet (TS 23.040, 9.2.3.1 and 9.2.3.25). */
    private static final int TYPE_MASK = 0x03;

    private static final int SUBMIT = 0x01;
    private static final int REJECT_DUPLICATES = 0x04;

    /** The message of one dialogue. */
    private sealed interface Item {
        int reference();
    }

    /** @param tpdu SUBMIT or COMMAND; reference and duplicate bit are set at submission */
    private record Part(OutgoingMessage message, int reference, OctetString tpdu, Msisdn serviceCenter)
            implements Item {}

    /** RP-SMMA (TS 24.011, 7.3.2). */
    private record MemoryAvailable(int reference) implements Item {}

    private final StationContext context;
    private final ServiceRequests services;
    private final DeliveryReports reports;
    private final StateMachine<OutgoingMessageState, OutgoingMessageEvent, OutgoingMessageAction> machine;
    private final Deque<Item> queue = new ArrayDeque<>();
    /** Number of the next part; its low octet is the reference. */
    private int nextNumber;

    private int nextTransaction;
    private TransactionIdentifier transaction = new TransactionIdentifier(0, false);
    private int retransmissions;
    private int losses;
    private boolean repeated;
    private RpCause failure = RpCause.TEMPORARY_FAILURE;

    MessageSender(StationContext context, ServiceRequests services, DeliveryReports reports, int firstReference) {
        this.context = context;
        this.services = services;
        this.reports = reports;
        this.nextNumber = firstReference;
        machine = new StateMachine<>(
                OutgoingMessageTable.TABLE, context.identity().number(), this::perform);
    }

    int send(Msisdn to, String text) {
        int id = nextNumber;
        List<UserData> texts = MessageSplitter.split(text, id & REFERENCE_MASK);
        OutgoingMessage message = new OutgoingMessage(id, to, texts.size(), context.events());
        for (UserData data : texts) {
            add(
                    message,
                    TpduCodec.encode(SubmitTpdu.of(0, SmsAddress.of(to), data)),
                    context.identity().serviceCenter());
        }
        sendNext();
        return id;
    }

    int submit(OctetString tpdu, Msisdn to, Msisdn serviceCenter) {
        int id = nextNumber;
        add(new OutgoingMessage(id, to, 1, context.events()), tpdu, serviceCenter);
        sendNext();
        return id;
    }

    private void add(OutgoingMessage message, OctetString tpdu, Msisdn serviceCenter) {
        queue.add(new Part(message, nextNumber & REFERENCE_MASK, tpdu, serviceCenter));
        nextNumber++;
    }

    /** Queues RP-SMMA, if none is queued. */
    void sendMemoryAvailable() {
        if (queue.stream().noneMatch(MemoryAvailable.class::isInstance)) {
            queue.add(new MemoryAvailable(nextNumber & REFERENCE_MASK));
            sendNext();
        }
    }

    /** All queued messages fail. */
    void powerOff() {
        Deque<Item> waiting = new ArrayDeque<>(queue);
        Item current = machine.state() == OutgoingMessageState.IDLE ? null : waiting.peek();
        queue.clear();
        failure = RpCause.NETWORK_OUT_OF_ORDER;
        OutgoingMessage last = current instanceof Part part ? part.message() : null;
        if (current != null) {
            queue.add(current);
            machine.fire(OutgoingMessageEvent.POWER_OFF);
        }
        for (Item item : waiting) {
            if (item instanceof Part part && part.message() != last) {
                last = part.message();
                last.failed(failure);
            }
        }
    }

    @Override
    public void connected() {
        transaction = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        retransmissions = 0;
        machine.fire(OutgoingMessageEvent.MM_CONNECTED);
    }

    @Override
    public void refused(RejectCause cause) {
        fail(
                OutgoingMessageEvent.MM_REFUSED,
                cause == RejectCause.CONGESTION ? RpCause.CONGESTION : RpCause.NETWORK_OUT_OF_ORDER);
    }

    @Override
    public void lost() {
        if (isInDialogue() && ++losses > MAX_LOSSES) {
            fail(OutgoingMessageEvent.RADIO_LOST_FINALLY, RpCause.NETWORK_OUT_OF_ORDER);
        } else {
            machine.fire(OutgoingMessageEvent.RADIO_LOST);
        }
    }

    private boolean isInDialogue() {
        return machine.state() == OutgoingMessageState.WAIT_FOR_CP_ACK
                || machine.state() == OutgoingMessageState.WAIT_FOR_RP_ACK;
    }

    /** True if messages with this transaction, as received, belong to the message being sent. */
    boolean has(TransactionIdentifier received) {
        return isInDialogue() && received.answered().equals(transaction);
    }

    void acknowledged() {
        machine.fire(OutgoingMessageEvent.CP_ACK);
    }

    /** CP-ERROR has arrived. */
    void failed(int cpCause) {
        fail(OutgoingMessageEvent.CP_ERROR, cpCause == CP_CONGESTION ? RpCause.CONGESTION : RpCause.TEMPORARY_FAILURE);
    }

    /** The answer to RP-DATA; one with another reference is only acknowledged (TS 24.011, 9.3.1). */
    void answered(RelayMessage answer) {
        if (answer.reference() != queue.element().reference()) {
            context.log().trace(Level.WARNING, "RP message for {0} is not expected", answer.reference());
            context.radio().send(new CpAck(transaction));
        } else if (answer instanceof RelayMessage.RpError error) {
            fail(OutgoingMessageEvent.RP_ERROR, error.cause());
        } else {
            machine.fire(OutgoingMessageEvent.RP_ACK);
        }
    }

    private void tc1Expired() {
        if (++retransmissions > MAX_RETRANSMISSIONS) {
            fail(OutgoingMessageEvent.TC1_EXPIRED_FINALLY, RpCause.TEMPORARY_FAILURE);
        } else {
            machine.fire(OutgoingMessageEvent.TC1_EXPIRED);
        }
    }

    private void fail(OutgoingMessageEvent event, RpCause cause) {
        failure = cause;
        machine.fire(event);
    }

    private void perform(OutgoingMessageAction action) {
        switch (action) {
            case REQUEST_CONNECTION -> services.request(ServiceType.SHORT_MESSAGE);
            case RELEASE_CONNECTION -> services.release(ServiceType.SHORT_MESSAGE);
            case COMPLETE_CONNECTION -> services.complete(ServiceType.SHORT_MESSAGE);
            case SEND_CP_DATA -> sendItem();
            case SEND_CP_ACK -> context.radio().send(new CpAck(transaction));
            case START_WAIT ->
                context.timers()
                        .start(
                                StationTimer.MESSAGE_WAIT,
                                () -> fail(OutgoingMessageEvent.WAIT_EXPIRED, RpCause.NETWORK_OUT_OF_ORDER));
            case START_TC1 -> context.timers().start(StationTimer.TC1_OUTGOING, this::tc1Expired);
            case START_TR1M ->
                context.timers()
                        .start(
                                StationTimer.TR1M,
                                () -> fail(OutgoingMessageEvent.TR1M_EXPIRED, RpCause.TEMPORARY_FAILURE));
            case STOP_TC1 -> context.timers().stop(StationTimer.TC1_OUTGOING);
            case STOP_TIMERS ->
                context.timers().stop(StationTimer.MESSAGE_WAIT, StationTimer.TC1_OUTGOING, StationTimer.TR1M);
            case MARK_REPEATED -> repeated = true;
            case REPORT_SENT -> itemSent();
            case REPORT_FAILED -> itemFailed();
            case SEND_NEXT -> sendNext();
        }
    }

    private void sendItem() {
        Item item = queue.element();
        if (item instanceof Part part) {
            reports.expect(part.reference(), part.message());
        }
        context.radio().send(new CpData(transaction, relay(item)));
    }

    private RelayMessage relay(Item item) {
        return item instanceof Part part
                ? new RpData(part.reference(), part.serviceCenter(), numbered(part))
                : new RelayMessage.RpSmma(item.reference());
    }

    /** With TP-MR in the second octet and, for a repeated SUBMIT, TP-RD (TS 23.040, 9.2.2.2). */
    private OctetString numbered(Part part) {
        byte[] octets = part.tpdu().toArray();
        octets[1] = (byte) part.reference();
        if (repeated && (octets[0] & TYPE_MASK) == SUBMIT) {
            octets[0] |= REJECT_DUPLICATES;
        }
        return OctetString.of(octets);
    }

    private void itemSent() {
        if (removeItem() instanceof Part part) {
            part.message().partAcknowledged();
        }
    }

    /**
     * A message fails with its first failing part. RP-SMMA is not repeated: the network retries by its own schedule.
     */
    private void itemFailed() {
        if (removeItem() instanceof Part part) {
            reports.cancel(part.reference(), part.message());
            queue.removeIf(item -> item instanceof Part other && other.message() == part.message());
            part.message().failed(failure);
        }
    }

    private Item removeItem() {
        repeated = false;
        losses = 0;
        return queue.remove();
    }

    private void sendNext() {
        if (machine.state() == OutgoingMessageState.IDLE && !queue.isEmpty()) {
            machine.fire(OutgoingMessageEvent.SEND);
        }
    }
}
