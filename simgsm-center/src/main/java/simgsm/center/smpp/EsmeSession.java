package simgsm.center.smpp;

import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.center.smpp.MessageStatusStore.MessageStatus;
import simgsm.center.smpp.SmppSessionTable.SmppSessionAction;
import simgsm.center.smpp.SmppSessionTable.SmppSessionEvent;
import simgsm.center.smpp.SmppSessionTable.SmppSessionState;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** A connection with an application: {@link SmppSessionTable} driven by PDUs and timers. */
public final class EsmeSession {
    /** session_init_timer (7.2): the connection is closed if the application does not bind. */
    static final long INIT_NANOS = Duration.ofSeconds(30).toNanos();
    /** enquire_link_timer (7.2): enquire_link is sent after this silence. */
    static final long ENQUIRE_NANOS = Duration.ofSeconds(60).toNanos();
    /** response_timer (7.2) of enquire_link. */
    static final long ANSWER_NANOS = Duration.ofSeconds(30).toNanos();
    /** The connection is closed after this number of refused binds, which slows the guessing of passwords. */
    static final int MAX_REFUSED_BINDS = 5;

    private static final System.Logger LOG = System.getLogger(EsmeSession.class.getName());

    private final SmppServer server;
    private final SmppPort port;
    private final String address;
    private final boolean isLocal;
    private final Timers timers;
    private final SmppFramer framer = new SmppFramer();
    private final DeliveryWindow window;
    private final SubmissionLimits limits;
    private final StateMachine<SmppSessionState, SmppSessionEvent, SmppSessionAction> machine =
            new StateMachine<>(SmppSessionTable.ROWS, this, this::perform);
    private boolean isClosed;
    private String systemId = "";
    private Optional<AddressRange> range = Optional.empty();
    private int refusedBinds;
    private int sequence;
    private long heardNanos;
    private Timer silence;
    private boolean isEnquired;

    EsmeSession(SmppServer server, SmppPort port, String address, boolean isLocal) {
        this.server = server;
        this.port = port;
        this.address = address;
        this.isLocal = isLocal;
        this.timers = server.timers().ownedBy(this::failed);
        this.window = new DeliveryWindow(this, timers, this::roomMade, this::unbind);
        this.limits = new SubmissionLimits(timers, isLocal);
        heardNanos = timers.nowNanos();
        silence = timers.start(INIT_NANOS, this::checkSilence);
    }

    String systemId() {
        return systemId;
    }

    SmppSessionState state() {
        return machine.state();
    }

    int outstanding() {
        return window.outstanding();
    }

    boolean hasRoom() {
        return window.hasRoom();
    }

    void setWindow(int deliveries) {
        window.setSize(deliveries);
    }

    int deliveryRank() {
        return window.rank();
    }

    /** Octets have arrived, in pieces of any length. */
    public void received(ByteBuffer octets) {
        if (isClosed) {
            return;
        }
        heardNanos = timers.nowNanos();
        isEnquired = false;
        framer.accept(octets);
        try {
            while (!isClosed && state() != SmppSessionState.UNBOUND && framer.hasNext()) {
                receiveNext();
            }
        } catch (SmppViolation lost) {
            LOG.log(Level.INFO, "{0}: {1}", this, lost.getMessage());
            lost.answer().ifPresent(this::send);
            endWhenSent();
        }
    }

    private void receiveNext() {
        try {
            receive(framer.next());
        } catch (SmppViolation violation) {
            LOG.log(Level.DEBUG, "{0}: {1}", this, violation.getMessage());
            violation.answer().ifPresent(this::send);
        }
    }

    private void receive(SmppPdu pdu) {
        if (pdu instanceof SmppPdu.Bind bind) {
            request(bind.command(), bind.sequence(), () -> bind(bind));
        } else if (pdu instanceof SmppPdu.Message message) {
            request(message.command(), message.sequence(), () -> submit(message));
        } else if (pdu instanceof SmppPdu.Plain plain) {
            request(plain.command(), plain.sequence(), () -> acknowledge(plain.command(), plain.sequence()));
        } else if (pdu instanceof SmppPdu.Query query) {
            request(SmppCommand.QUERY_SM, query.sequence(), () -> query(query));
        } else if (pdu instanceof SmppPdu.Cancel cancel) {
            request(SmppCommand.CANCEL_SM, cancel.sequence(), () -> cancel(cancel));
        } else if (pdu instanceof SmppPdu.MessageResponse response) {
            window.answered(response.sequence(), outcome(response.status()));
        } else if (pdu instanceof SmppPdu.GenericNack nack) {
            window.answered(nack.sequence(), outcome(nack.status()));
        }
    }

    /** Fulfils a request; SmppViolation refuses it. */
    private interface Fulfilment {
        void run() throws SmppViolation;
    }

    private void request(SmppCommand command, int number, Fulfilment fulfilment) {
        SmppSessionEvent event = SmppSessionEvent.of(command);
        if (!machine.accepts(event)) {
            boolean isSecondBind = command.isBind() && state().isBound();
            int status = isSecondBind ? SmppStatus.ALREADY_BOUND : SmppStatus.INVALID_BIND_STATUS;
            send(SmppCodec.refusal(command, status, number));
            return;
        }
        try {
            fulfilment.run();
            machine.fire(event);
        } catch (SmppViolation refused) {
            LOG.log(Level.DEBUG, "{0}: {1} refused, {2}", this, command, refused.getMessage());
            send(SmppCodec.refusal(command, refused.status(), number));
            if (refusedBinds == MAX_REFUSED_BINDS) {
                endWhenSent();
            }
        }
    }

    private void perform(SmppSessionAction action) {
        switch (action) {
            case ADD_TO_ROUTES -> server.bound(this, range);
            case REMOVE_FROM_ROUTES -> removeFromRoutes();
            case CLOSE_CONNECTION -> port.closeWhenSent();
        }
    }

    private void removeFromRoutes() {
        server.unbound(this, range);
        window.end();
        server.routes().roomOn(this, range, server);
        systemId = "";
    }

    private void bind(SmppPdu.Bind bind) throws SmppViolation {
        int status = server.users().check(bind.systemId(), bind.password(), isLocal);
        if (status != SmppStatus.OK) {
            refusedBinds++;
            LOG.log(Level.INFO, "{0}: {1} may not bind, status {2}", this, bind.systemId(), status);
            throw new SmppViolation(status, "system id or password");
        }
        try {
            range = bind.addressRange().isEmpty()
                    ? Optional.empty()
                    : Optional.of(AddressRange.parse(bind.addressRange()));
        } catch (IllegalArgumentException e) {
            throw new SmppViolation(SmppStatus.BIND_FAILED, e.getMessage());
        }
        systemId = bind.systemId();
        send(new SmppPdu.BindResponse(bind.command(), SmppStatus.OK, bind.sequence(), SmppServer.SYSTEM_ID));
    }

    private void acknowledge(SmppCommand command, int number) {
        send(new SmppPdu.PlainResponse(command, SmppStatus.OK, number));
    }

    private void submit(SmppPdu.Message pdu) throws SmppViolation {
        if (!limits.admit()) {
            throw new SmppViolation(SmppStatus.THROTTLED, "too many submissions at a time");
        }
        Msisdn ownNumber = range.flatMap(AddressRange::exact).orElse(ShortMessageCenter.ADDRESS);
        limits.begun();
        try {
            server.submissions().submit(systemId, ownNumber, pdu.message(), (id, status) -> {
                limits.answered();
                send(new SmppPdu.MessageResponse(pdu.command(), status, pdu.sequence(), id));
            });
        } catch (SmppViolation refused) {
            limits.answered();
            throw refused;
        }
    }

    private void query(SmppPdu.Query query) throws SmppViolation {
        MessageStatus status = status(query.messageId(), query.source(), SmppStatus.QUERY_FAILED);
        boolean hasEnded = status.state() != MessageState.ACCEPTED;
        send(new SmppPdu.QueryResponse(
                SmppStatus.OK,
                query.sequence(),
                query.messageId(),
                hasEnded ? SmppTime.full(status.at()) : "",
                DeliverSm.messageState(status.state()),
                0));
    }

    private void cancel(SmppPdu.Cancel cancel) throws SmppViolation {
        MessageStatus status = status(cancel.messageId(), cancel.source(), SmppStatus.CANCEL_FAILED);
        if (!server.center().cancel(status.id())) {
            throw new SmppViolation(
                    SmppStatus.CANCEL_FAILED, "message " + cancel.messageId() + " has ended or is being delivered");
        }
        acknowledge(SmppCommand.CANCEL_SM, cancel.sequence());
    }

    /** @throws SmppViolation with {@code refusal} if this application has no such message */
    private MessageStatus status(String id, SmppAddress source, int refusal) throws SmppViolation {
        return server.statuses()
                .find(server.center(), id, systemId, source.value())
                .orElseThrow(() -> new SmppViolation(
                        refusal, systemId + " has no message \"" + id + "\" that waits or has lately ended"));
    }

    /** Sends deliver_sm. @param ended is given the outcome once: of the answer, of the timer, or of the session's end */
    void deliver(Envelope envelope, Consumer<DeliveryOutcome> ended) {
        int number = nextSequence();
        window.sent(number, ended);
        send(new SmppPdu.Message(SmppCommand.DELIVER_SM, number, DeliverSm.of(envelope)));
    }

    private int nextSequence() {
        sequence = sequence % Integer.MAX_VALUE + 1;
        return sequence;
    }

    private void roomMade() {
        if (state().receives()) {
            server.routes().roomOn(this, range, server);
        }
    }

    private static DeliveryOutcome outcome(int status) {
        if (status == SmppStatus.OK) {
            return DeliveryOutcome.DELIVERED;
        }
        if (SmppStatus.isBusy(status)) {
            return DeliveryOutcome.BUSY;
        }
        return SmppStatus.mayPass(status) ? DeliveryOutcome.POSTPONED : DeliveryOutcome.REFUSED;
    }

    private void checkSilence() {
        long silentNanos = timers.nowNanos() - heardNanos;
        if (!state().isBound() || isEnquired) {
            drop(isEnquired ? "does not answer enquire_link" : "does not bind");
        } else if (silentNanos >= ENQUIRE_NANOS) {
            isEnquired = true;
            send(new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, nextSequence()));
            silence = timers.start(ANSWER_NANOS, this::checkSilence);
        } else {
            silence = timers.start(ENQUIRE_NANOS - silentNanos, this::checkSilence);
        }
    }

    private void send(SmppPdu pdu) {
        if (!isClosed) {
            port.send(SmppCodec.encode(pdu));
        }
    }

    private void failed(RuntimeException e) {
        LOG.log(Level.ERROR, this + ": closed after an error of our own", e);
        drop("internal error");
    }

    private void drop(String reason) {
        port.close(reason);
        closed();
    }

    /** Ends a session that answers nothing. */
    private void unbind() {
        send(new SmppPdu.Plain(SmppCommand.UNBIND, nextSequence()));
        endWhenSent();
    }

    private void endWhenSent() {
        end();
        port.closeWhenSent();
        timers.start(ANSWER_NANOS, () -> port.close("does not read"));
    }

    /** The connection was closed by the peer, or is broken. */
    public void closed(String reason) {
        LOG.log(state().isBound() ? Level.INFO : Level.DEBUG, "{0}: gone, {1}", this, reason);
        closed();
    }

    private void closed() {
        end();
        isClosed = true;
    }

    private void end() {
        timers.cancel(silence);
        machine.fire(SmppSessionEvent.END);
    }

    @Override
    public String toString() {
        return systemId.isEmpty() ? "ESME at " + address : systemId + " at " + address;
    }
}
