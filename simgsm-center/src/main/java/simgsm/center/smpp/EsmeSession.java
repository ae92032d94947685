package simgsm.center.smpp;

import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryReceipt;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.Recipient;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.timer.Timer;

/** One connection with an application, from its opening to its end. */
public final class EsmeSession {
    /** session_init_timer (7.2): who does not bind is not kept. */
    static final long INIT_NANOS = Duration.ofSeconds(30).toNanos();
    /** enquire_link_timer: after so long a silence the application is asked whether it is there. */
    static final long ENQUIRE_NANOS = Duration.ofSeconds(60).toNanos();
    /** How long it may take to answer that. */
    static final long ANSWER_NANOS = Duration.ofSeconds(30).toNanos();
    /** Guessing passwords needs a new connection from time to time. */
    static final int MAX_REFUSED_BINDS = 5;

    private static final System.Logger LOG = System.getLogger(EsmeSession.class.getName());

    private final SmppServer server;
    private final SmppPort port;
    private final String address;
    private final boolean isLocal;
    private final SmppFramer framer = new SmppFramer();
    private final DeliveryWindow window;
    private final Throttle throttle;
    private SessionState state = SessionState.OPEN;
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
        this.window = new DeliveryWindow(server.timers());
        this.throttle = new Throttle(server.timers(), isLocal);
        heardNanos = server.timers().nowNanos();
        silence = server.timers().start(INIT_NANOS, this::checkSilence);
    }

    String systemId() {
        return systemId;
    }

    SessionState state() {
        return state;
    }

    int outstanding() {
        return window.size();
    }

    boolean hasRoom() {
        return window.size() < DeliveryWindow.SIZE;
    }

    void received(ByteBuffer octets) {
        if (isClosed) {
            return;
        }
        heardNanos = server.timers().nowNanos();
        isEnquired = false;
        framer.accept(octets);
        try {
            while (!isClosed && state != SessionState.UNBOUND && framer.hasNext()) {
                receiveNext();
            }
        } catch (SmppViolation lost) {
            LOG.log(Level.INFO, "{0}: {1}", this, lost.getMessage());
            lost.answer().ifPresent(this::send);
            end();
            port.closeWhenSent();
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
            request(plain.command(), plain.sequence(), () -> perform(plain));
        } else if (pdu instanceof SmppPdu.Query query) {
            request(SmppCommand.QUERY_SM, query.sequence(), () -> query(query));
        } else if (pdu instanceof SmppPdu.Cancel cancel) {
            request(SmppCommand.CANCEL_SM, cancel.sequence(), () -> cancel(cancel));
        } else if (pdu instanceof SmppPdu.MessageResponse response) {
            delivered(response.sequence(), response.status());
        } else if (pdu instanceof SmppPdu.GenericNack nack) {
            delivered(nack.sequence(), nack.status());
        }
    }

    /** What a request does; SmppViolation refuses it. */
    private interface Fulfilment {
        void run() throws SmppViolation;
    }

    private void request(SmppCommand command, int number, Fulfilment fulfilment) {
        Optional<SessionState> next = state.after(command);
        if (next.isEmpty()) {
            send(SmppCodec.refusal(command, state.refusal(command), number));
            return;
        }
        try {
            fulfilment.run();
            if (next.get() != state) {
                enter(next.get());
            }
        } catch (SmppViolation refused) {
            LOG.log(Level.DEBUG, "{0}: {1} refused, {2}", this, command, refused.getMessage());
            send(SmppCodec.refusal(command, refused.status(), number));
            if (refusedBinds == MAX_REFUSED_BINDS) {
                end();
                port.closeWhenSent();
            }
        }
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

    private void enter(SessionState next) {
        boolean began = !state.isBound() && next.isBound();
        state = next;
        if (began) {
            server.bound(this, range);
        } else if (next == SessionState.UNBOUND) {
            end();
            port.closeWhenSent();
        }
    }

    private void perform(SmppPdu.Plain plain) {
        send(new SmppPdu.PlainResponse(plain.command(), SmppStatus.OK, plain.sequence()));
    }

    private void submit(SmppPdu.Message pdu) throws SmppViolation {
        if (!throttle.admits()) {
            throw new SmppViolation(SmppStatus.THROTTLED, "too much at a time");
        }
        Msisdn ownNumber = range.flatMap(AddressRange::exact).orElse(ShortMessageCenter.ADDRESS);
        throttle.begun();
        Submission submission = new Submission(pdu.command(), pdu.sequence());
        try {
            submission.id = server.desk().submit(systemId, ownNumber, pdu.message(), submission::answer);
        } catch (SmppViolation refused) {
            throttle.answered();
            throw refused;
        }
        submission.flush();
    }

    /** A message that was handed in; its refusal may come before its id is known. */
    private final class Submission {
        private final SmppCommand command;
        private final int number;
        private int status = -1;
        private String id;

        Submission(SmppCommand command, int number) {
            this.command = command;
            this.number = number;
        }

        void answer(int answered) {
            status = answered;
            flush();
        }

        void flush() {
            if (id != null && status >= 0) {
                throttle.answered();
                send(new SmppPdu.MessageResponse(command, status, number, id));
            }
        }
    }

    private void query(SmppPdu.Query query) throws SmppViolation {
        MessageStatusStore.Fate fate = server.fates()
                .find(query.messageId(), systemId, query.source().value())
                .orElseThrow(() -> unknown(SmppStatus.QUERY_FAILED, query.messageId()));
        boolean isOver = fate.state() != MessageState.ACCEPTED;
        send(new SmppPdu.QueryResponse(
                SmppStatus.OK,
                query.sequence(),
                query.messageId(),
                isOver ? SmppTime.full(fate.at()) : "",
                Receipts.code(fate.state()),
                0));
    }

    private void cancel(SmppPdu.Cancel cancel) throws SmppViolation {
        MessageStatusStore.Fate fate = server.fates()
                .find(cancel.messageId(), systemId, cancel.source().value())
                .filter(found -> found.state() == MessageState.ACCEPTED)
                .orElseThrow(() -> unknown(SmppStatus.CANCEL_FAILED, cancel.messageId()));
        if (!server.center().cancel(fate.to(), Long.parseLong(cancel.messageId()))) {
            throw new SmppViolation(SmppStatus.CANCEL_FAILED, "message " + cancel.messageId() + " is being delivered");
        }
        send(new SmppPdu.PlainResponse(SmppCommand.CANCEL_SM, SmppStatus.OK, cancel.sequence()));
    }

    private SmppViolation unknown(int status, String id) {
        return new SmppViolation(status, systemId + " has no message \"" + id + "\" that waits or has lately ended");
    }

    /** Sends deliver_sm. The receipt is told when it is answered, or will not be. */
    void deliver(Envelope envelope, DeliveryReceipt receipt) {
        sequence = sequence % Integer.MAX_VALUE + 1;
        window.sent(sequence, envelope.receiver(), receipt);
        send(new SmppPdu.Message(SmppCommand.DELIVER_SM, sequence, Deliveries.of(envelope)));
    }

    private void delivered(int number, int status) {
        if (window.answered(number, outcome(status)) && state.receives()) {
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
        return SmppStatus.mayPass(status) ? DeliveryOutcome.FAILED : DeliveryOutcome.REFUSED;
    }

    private void checkSilence() {
        long silent = server.timers().nowNanos() - heardNanos;
        if (!state.isBound() || isEnquired) {
            port.close(isEnquired ? "does not answer enquire_link" : "does not bind");
            closed();
        } else if (silent >= ENQUIRE_NANOS) {
            isEnquired = true;
            sequence = sequence % Integer.MAX_VALUE + 1;
            send(new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, sequence));
            silence = server.timers().start(ANSWER_NANOS, this::checkSilence);
        } else {
            silence = server.timers().start(ENQUIRE_NANOS - silent, this::checkSilence);
        }
    }

    private void send(SmppPdu pdu) {
        if (!isClosed) {
            port.send(SmppCodec.encode(pdu));
        }
    }

    /** The connection is gone. */
    void closed() {
        end();
        isClosed = true;
    }

    /** Nothing is delivered any more; what was, without an answer, goes back to its queue. */
    private void end() {
        server.timers().cancel(silence);
        state = SessionState.UNBOUND;
        if (systemId.isEmpty()) {
            return;
        }
        server.unbound(this, range);
        List<Recipient> lost = window.lose();
        lost.forEach(server::tryAgain);
        server.routes().roomOn(this, range, server);
        systemId = "";
    }

    @Override
    public String toString() {
        return systemId.isEmpty() ? "ESME at " + address : systemId + " at " + address;
    }
}
