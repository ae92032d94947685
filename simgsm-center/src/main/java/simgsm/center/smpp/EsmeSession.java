package simgsm.center.smpp;

import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.center.smpp.SmppSessionTable.SmppSessionAction;
import simgsm.center.smpp.SmppSessionTable.SmppSessionEvent;
import simgsm.center.smpp.SmppSessionTable.SmppSessionState;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppFramer;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
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
    /** The connection is closed after this number of refused binds. */
    static final int MAX_REFUSED_BINDS = 5;

    private static final System.Logger LOG = System.getLogger(EsmeSession.class.getName());

    private final SmppServer server;
    private final SmppPort port;
    private final String address;
    private final boolean isLocal;
    private final Timers timers;
    private final SmppFramer framer = new SmppFramer();
    private final DeliveryWindow window;
    private final RequestLimits limits;
    private final StateMachine<SmppSessionState, SmppSessionEvent, SmppSessionAction> machine =
            new StateMachine<>(SmppSessionTable.ROWS, this, this::perform);
    private boolean isClosed;
    private String systemId = "";
    private Optional<AddressRange> range = Optional.empty();
    private EsmeSettings settings = EsmeSettings.STANDARD;
    /** True if the application uses SMPP 3.4 (3.4.2). */
    private boolean takesParameters;

    private MessageRequests.Requester requester;
    private int refusedBinds;
    private Timer pendingBind;
    /** Runs from the end until the peer has read it. */
    private Timer closing;

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
        this.limits = new RequestLimits(timers, isLocal);
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

    /** True if the application may serve and send as a number, or send as a name. */
    boolean permits(String value) {
        return server.permits(systemId, value);
    }

    boolean hasRoom() {
        return window.hasRoom();
    }

    int deliveryRank() {
        return window.rank();
    }

    /** Processes octets in pieces of any length. */
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
            limits.admit();
            violation.answer().ifPresent(this::send);
        }
    }

    private void receive(SmppPdu pdu) {
        if (!(pdu instanceof SmppPdu.Response)) {
            request(pdu);
        } else if (pdu instanceof SmppPdu.MessageResponse response) {
            window.answered(response.sequence(), outcome(response.status()));
        } else if (pdu instanceof SmppPdu.GenericNack nack) {
            window.answered(nack.sequence(), outcome(nack.status()));
        }
    }

    private void request(SmppPdu request) {
        SmppCommand command = request.command();
        try {
            SmppSessionEvent event = SmppSessionEvent.of(command);
            if (!machine.accepts(event)) {
                boolean isSecondBind = command.isBind() && state().isBound();
                throw new SmppViolation(
                        isSecondBind ? SmppStatus.ALREADY_BOUND : SmppStatus.INVALID_BIND_STATUS, "in " + state());
            }
            if (!limits.admit() && !(request instanceof SmppPdu.Plain)) {
                throw new SmppViolation(SmppStatus.THROTTLED, "too many requests at a time");
            }
            if (request instanceof SmppPdu.Bind bind) {
                bindInTurn(bind);
            } else {
                fulfil(request);
                machine.fire(event);
            }
        } catch (SmppViolation refusal) {
            refuse(request, refusal);
        }
    }

    private void refuse(SmppPdu request, SmppViolation refusal) {
        LOG.log(Level.DEBUG, "{0}: {1} refused, {2}", this, request.command(), refusal.getMessage());
        send(SmppCodec.refusal(request, refusal.status()));
        if (refusedBinds >= MAX_REFUSED_BINDS) {
            endWhenSent();
        }
    }

    private void fulfil(SmppPdu request) throws SmppViolation {
        if (request instanceof SmppPdu.Plain) {
            send(new SmppPdu.PlainResponse(request.command(), SmppStatus.OK, request.sequence()));
            return;
        }
        limits.begun();
        try {
            server.requests().fulfil(requester, request, response -> {
                limits.answered();
                send(response);
            });
        } catch (SmppViolation refused) {
            limits.answered();
            throw refused;
        }
    }

    private void perform(SmppSessionAction action) {
        switch (action) {
            case ADD_TO_ROUTES -> {
                port.bound();
                server.bound(this, range);
            }
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

    /** Binds now, or after the pause for refused binds from the same address. */
    private void bindInTurn(SmppPdu.Bind bind) throws SmppViolation {
        long waitNanos = server.bindLimiter().waitNanos(host(), timers.nowNanos());
        if (waitNanos == BindLimiter.REFUSED || pendingBind != null) {
            refusedBinds = MAX_REFUSED_BINDS;
            throw new SmppViolation(SmppStatus.BIND_FAILED, "too many binds from " + host());
        } else if (waitNanos == 0) {
            bind(bind, false);
        } else {
            pendingBind = timers.start(waitNanos, () -> {
                pendingBind = null;
                try {
                    bind(bind, true);
                } catch (SmppViolation refusal) {
                    refuse(bind, refusal);
                }
            });
        }
    }

    private void bind(SmppPdu.Bind bind, boolean hasWaited) throws SmppViolation {
        int status = server.users().check(bind.systemId(), bind.password(), isLocal);
        if (status != SmppStatus.OK) {
            refusedBinds++;
            server.bindLimiter().refused(host(), bind.systemId(), status, hasWaited, timers.nowNanos());
            throw new SmppViolation(status, "system id or password");
        }
        range = range(bind);
        systemId = bind.systemId();
        takesParameters = bind.interfaceVersion() >= SmppCodec.INTERFACE_VERSION;
        settings = server.users().settings(systemId);
        window.setSize(settings.window());
        settings.requestsPerSecond().ifPresent(limits::setRate);
        requester = new MessageRequests.Requester(
                systemId,
                range.flatMap(AddressRange::exact).orElse(ShortMessageCenter.ADDRESS),
                settings.alphabet(),
                this::permits);
        send(new SmppPdu.BindResponse(bind.command(), SmppStatus.OK, bind.sequence(), SmppServer.SYSTEM_ID));
        machine.fire(SmppSessionEvent.of(bind.command()));
    }

    private Optional<AddressRange> range(SmppPdu.Bind bind) throws SmppViolation {
        if (bind.addressRange().isEmpty()) {
            return Optional.empty();
        }
        NumberOwners owners = server.users().owners();
        String id = bind.systemId();
        AddressRange asked;
        try {
            asked = AddressRange.parse(bind.addressRange(), owners.isOwner(id) ? id : "");
        } catch (IllegalArgumentException e) {
            throw new SmppViolation(SmppStatus.BIND_FAILED, e.getMessage());
        }
        if (asked.isPrefix() ? !owners.permitsPrefix(id, asked.digits()) : !server.permits(id, asked.digits())) {
            throw new SmppViolation(SmppStatus.BIND_FAILED, asked + " is not a number of " + id);
        }
        return Optional.of(asked);
    }

    /** The peer's address without its port. */
    private String host() {
        int port = address.lastIndexOf(':');
        return port < 0 ? address : address.substring(0, port);
    }

    /**
     * Sends deliver_sm.
     *
     * @param ended receives the outcome once: of the answer, of the timer, or of the session's end
     */
    void deliver(Envelope envelope, Consumer<DeliveryOutcome> ended) {
        int number = nextSequence();
        window.sent(number, ended);
        send(new SmppPdu.Message(
                SmppCommand.DELIVER_SM, number, DeliverSm.of(envelope, settings.alphabet(), takesParameters)));
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

    private DeliveryOutcome outcome(int status) {
        if (status == SmppStatus.OK) {
            return DeliveryOutcome.DELIVERED;
        }
        if (!settings.retries().getOrDefault(status, SmppStatus.mayPass(status))) {
            return DeliveryOutcome.REFUSED;
        }
        return SmppStatus.isBusy(status) ? DeliveryOutcome.BUSY : DeliveryOutcome.POSTPONED;
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
            port.send(SmppCodec.encode(pdu, takesParameters));
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
        closing = timers.start(ANSWER_NANOS, () -> port.close("does not read"));
    }

    /** The connection was closed by the peer, or is broken. */
    public void closed(String reason) {
        LOG.log(state().isBound() ? Level.INFO : Level.DEBUG, "{0}: gone, {1}", this, reason);
        closed();
    }

    private void closed() {
        timers.cancel(closing);
        end();
        isClosed = true;
    }

    private void end() {
        timers.cancel(silence);
        timers.cancel(pendingBind);
        machine.fire(SmppSessionEvent.END);
    }

    @Override
    public String toString() {
        return systemId.isEmpty() ? "ESME at " + address : systemId + " at " + address;
    }
}
