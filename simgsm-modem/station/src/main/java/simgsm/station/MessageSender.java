package simgsm.station;

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
import simgsm.sms.MessageSplitter;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

/** Sends queued messages, one part after the other: performs what {@link OutgoingTable} says. */
final class MessageSender implements ServiceRequests.User {
    private static final int REFERENCES = 256;
    private static final int TRANSACTIONS = 7;
    private static final int MOST_RETRANSMISSIONS = 3;
    /** A message whose radio connection is lost so often under it is given up. */
    private static final int MOST_LOSSES = 3;

    private static final int CP_CONGESTION = 22;

    /** What one dialogue carries up. */
    private sealed interface Item {
        int reference();
    }

    private record Part(OutgoingMessage message, int reference, UserData data) implements Item {}

    /** RP-SMMA (TS 24.011, 7.3.2). */
    private record MemoryAvailable(int reference) implements Item {}

    private final StationParts parts;
    private final ServiceRequests services;
    private final DeliveryReports reports;
    private final Deque<Item> queue = new ArrayDeque<>();
    private OutgoingState state = OutgoingState.IDLE;
    private int nextReference;
    private int nextTransaction;
    private TransactionIdentifier transaction = new TransactionIdentifier(0, false);
    private int retransmissions;
    private int losses;
    private boolean repeated;
    private RpCause failure = RpCause.TEMPORARY_FAILURE;

    MessageSender(StationParts parts, ServiceRequests services, DeliveryReports reports, int firstReference) {
        this.parts = parts;
        this.services = services;
        this.reports = reports;
        this.nextReference = firstReference;
    }

    int send(Msisdn to, String text) {
        List<UserData> texts = MessageSplitter.split(text, nextReference);
        int id = nextReference;
        OutgoingMessage message = new OutgoingMessage(id, to, texts.size(), parts.notifications());
        for (UserData data : texts) {
            queue.add(new Part(message, nextReference, data));
            nextReference = (nextReference + 1) % REFERENCES;
        }
        sendNext();
        return id;
    }

    /** There is room for messages again; told once, however often it was asked for. */
    void tellMemoryAvailable() {
        if (queue.stream().noneMatch(MemoryAvailable.class::isInstance)) {
            queue.add(new MemoryAvailable(nextReference));
            sendNext();
        }
    }

    void powerOff() {
        Deque<Item> waiting = new ArrayDeque<>(queue);
        Item current = state == OutgoingState.IDLE ? null : waiting.peek();
        queue.clear();
        failure = RpCause.NETWORK_OUT_OF_ORDER;
        OutgoingMessage last = current instanceof Part part ? part.message() : null;
        if (current != null) {
            queue.add(current);
            happens(OutgoingEvent.POWER_OFF);
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
        happens(OutgoingEvent.MM_CONNECTED);
    }

    @Override
    public void refused(RejectCause cause) {
        fails(
                OutgoingEvent.MM_REFUSED,
                cause == RejectCause.CONGESTION ? RpCause.CONGESTION : RpCause.NETWORK_OUT_OF_ORDER);
    }

    @Override
    public void lost() {
        boolean inDialogue = state == OutgoingState.WAIT_FOR_CP_ACK || state == OutgoingState.WAIT_FOR_RP_ACK;
        if (inDialogue && ++losses > MOST_LOSSES) {
            fails(OutgoingEvent.RADIO_LOST_FINALLY, RpCause.NETWORK_OUT_OF_ORDER);
        } else {
            happens(OutgoingEvent.RADIO_LOST);
        }
    }

    boolean isOurs(TransactionIdentifier received) {
        return state != OutgoingState.IDLE
                && state != OutgoingState.MM_CONNECTION_PENDING
                && received.answered().equals(transaction);
    }

    void acknowledged() {
        happens(OutgoingEvent.CP_ACK);
    }

    void failedAtTheOtherEnd(int cpCause) {
        fails(OutgoingEvent.CP_ERROR, cpCause == CP_CONGESTION ? RpCause.CONGESTION : RpCause.TEMPORARY_FAILURE);
    }

    /** The answer to our RP-DATA; another's is acknowledged and left alone (TS 24.011, 9.3.1). */
    void answered(RelayMessage answer) {
        if (answer.reference() != queue.element().reference()) {
            parts.log().trace(Level.WARNING, "RP message for {0} is not expected", answer.reference());
            parts.radio().send(new CpAck(transaction));
        } else if (answer instanceof RelayMessage.RpError error) {
            fails(OutgoingEvent.RP_ERROR, error.cause());
        } else {
            happens(OutgoingEvent.RP_ACK);
        }
    }

    void expired(StationTimer timer) {
        switch (timer) {
            case MESSAGE_WAIT -> fails(OutgoingEvent.WAIT_EXPIRED, RpCause.NETWORK_OUT_OF_ORDER);
            case TR1M -> fails(OutgoingEvent.TR1M_EXPIRED, RpCause.TEMPORARY_FAILURE);
            default -> tc1Expired();
        }
    }

    private void tc1Expired() {
        if (++retransmissions > MOST_RETRANSMISSIONS) {
            fails(OutgoingEvent.TC1_EXPIRED_FINALLY, RpCause.TEMPORARY_FAILURE);
        } else {
            happens(OutgoingEvent.TC1_EXPIRED);
        }
    }

    private void fails(OutgoingEvent event, RpCause cause) {
        failure = cause;
        happens(event);
    }

    private void happens(OutgoingEvent event) {
        var row = OutgoingTable.ROWS.row(state, event);
        if (row.isEmpty()) {
            parts.log().refused(state, event);
            return;
        }
        parts.log().trace(Level.DEBUG, "{0} {1} -> {2}", state, event, row.get().next());
        state = row.get().next();
        row.get().actions().forEach(this::perform);
    }

    private void perform(OutgoingAction action) {
        switch (action) {
            case REQUEST_CONNECTION -> services.request(ServiceType.SHORT_MESSAGE);
            case RELEASE_CONNECTION -> services.release(ServiceType.SHORT_MESSAGE);
            case END_CONNECTION -> services.done(ServiceType.SHORT_MESSAGE);
            case SEND_CP_DATA -> sendItem();
            case SEND_CP_ACK -> parts.radio().send(new CpAck(transaction));
            case START_WAIT -> parts.timers().start(StationTimer.MESSAGE_WAIT);
            case START_TC1 -> parts.timers().start(StationTimer.TC1_OUTGOING);
            case START_TR1M -> parts.timers().start(StationTimer.TR1M);
            case STOP_TC1 -> parts.timers().stop(StationTimer.TC1_OUTGOING);
            case STOP_TIMERS -> stopTimers();
            case MARK_REPEATED -> repeated = true;
            case TELL_SENT -> itemSent();
            case TELL_FAILED -> itemFailed();
            case SEND_NEXT -> sendNext();
        }
    }

    private void sendItem() {
        Item item = queue.element();
        if (item instanceof Part part) {
            reports.expect(part.reference(), part.message());
        }
        parts.radio().send(new CpData(transaction, relay(item)));
    }

    private RelayMessage relay(Item item) {
        return item instanceof Part part
                ? new RpData(part.reference(), parts.identity().serviceCenter(), TpduCodec.encode(submit(part)))
                : new RelayMessage.RpSmma(item.reference());
    }

    private SubmitTpdu submit(Part part) {
        SubmitTpdu plain =
                SubmitTpdu.of(part.reference(), SmsAddress.of(part.message().to()), part.data());
        return new SubmitTpdu(
                repeated,
                plain.statusReportRequest(),
                plain.replyPath(),
                plain.reference(),
                plain.destination(),
                plain.protocolIdentifier(),
                plain.validity(),
                plain.userData());
    }

    private void itemSent() {
        if (queue.remove() instanceof Part part) {
            part.message().partAcknowledged();
        }
        repeated = false;
        losses = 0;
    }

    /** Without one of its parts the whole message is lost. A network that does not hear of memory tries by its schedule. */
    private void itemFailed() {
        if (queue.remove() instanceof Part part) {
            reports.cancel(part.reference(), part.message());
            queue.removeIf(item -> item instanceof Part other && other.message() == part.message());
            part.message().failed(failure);
        }
        repeated = false;
        losses = 0;
    }

    private void sendNext() {
        if (state == OutgoingState.IDLE && !queue.isEmpty()) {
            happens(OutgoingEvent.SEND);
        }
    }

    private void stopTimers() {
        parts.timers().stop(StationTimer.MESSAGE_WAIT);
        parts.timers().stop(StationTimer.TC1_OUTGOING);
        parts.timers().stop(StationTimer.TR1M);
    }
}
