package simgsm.station.ss;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.ProtocolViolation;
import simgsm.air.RejectCause;
import simgsm.air.SupplementaryService;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.sms.Alphabet;
import simgsm.ss.Component;
import simgsm.ss.Component.Invoke;
import simgsm.ss.Component.Reject;
import simgsm.ss.Component.ReturnError;
import simgsm.ss.Component.ReturnResult;
import simgsm.ss.ComponentCodec;
import simgsm.ss.ComponentFault;
import simgsm.ss.ServiceCode;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsArgument;
import simgsm.ss.SsCode;
import simgsm.ss.SsError;
import simgsm.ss.SsOperation;
import simgsm.ss.SsProblem;
import simgsm.ss.UssdText;
import simgsm.state.StateMachine;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationTimer;
import simgsm.station.context.UssdEnding;
import simgsm.station.mobility.ServiceRequests;
import simgsm.station.ss.MobileUssdTable.MobileUssdAction;
import simgsm.station.ss.MobileUssdTable.MobileUssdEvent;
import simgsm.station.ss.MobileUssdTable.MobileUssdState;

/**
 * USSD of a station: one dialogue at a time, begun by the user or by the network; runs by {@link MobileUssdTable}. A
 * second one begun by the network is refused with the error "USSD busy".
 */
public final class MobileUssd implements ServiceRequests.ServiceUser {
    private static final int TRANSACTIONS = 7;
    /** Invoke identifier of the user's request; each dialogue has only one. */
    private static final int REQUEST_ID = 1;

    private final StationContext context;
    private final ServiceRequests services;
    private final StateMachine<MobileUssdState, MobileUssdEvent, MobileUssdAction> machine;
    private int nextTransaction;
    /** As in messages sent: the flag is set if the network began the dialogue. */
    private TransactionIdentifier transaction = new TransactionIdentifier(0, false);
    /** The user's last component: a request, or the result of the network's question. */
    private Component typed;
    /** The network's latest text. */
    private String shown = "";
    /** The network's latest operation, to be answered. */
    private Invoke asked;

    /** The report of the network's last component. */
    private Optional<StationEvent> lastWord = Optional.empty();

    private UssdEnding ending = UssdEnding.COMPLETED;
    private Optional<SsError> error = Optional.empty();

    public MobileUssd(StationContext context, ServiceRequests services) {
        this.context = context;
        this.services = services;
        machine = new StateMachine<>(MobileUssdTable.TABLE, context.identity().number(), this::perform);
    }

    /** True if the network waits for the user's reply. */
    private boolean awaitsReply() {
        return machine.state() == MobileUssdState.WAIT_FOR_USER;
    }

    /** True if the network has begun the dialogue and waits for the user's reply. */
    public boolean isAskedByNetwork() {
        return awaitsReply() && transaction.fromOtherSide();
    }

    /**
     * Sends the user's text: the reply to the network, or else a request, possibly of a supplementary service.
     *
     * @return false if a dialogue is under way and the network has not asked
     * @throws IllegalArgumentException for a text that is empty or too long
     */
    public boolean send(String text) {
        boolean isReply = awaitsReply();
        Component component = isReply
                ? new ReturnResult(
                        asked.id(),
                        SsOperation.UNSTRUCTURED_SS_REQUEST,
                        UssdText.of(text).encode())
                : ServiceCode.invoke(REQUEST_ID, text);
        MobileUssdEvent event = isReply ? MobileUssdEvent.USER_REPLIES : MobileUssdEvent.USER_REQUESTS;
        if (!machine.accepts(event)) {
            return false;
        }
        typed = component;
        return machine.fire(event);
    }

    /** Ends the dialogue for the user. @return false if there is none */
    public boolean end() {
        return end(MobileUssdEvent.USER_ENDS, UssdEnding.CANCELLED);
    }

    public void powerOff() {
        end(MobileUssdEvent.POWER_OFF, UssdEnding.NO_SERVICE);
    }

    private boolean end(MobileUssdEvent event, UssdEnding how) {
        setEnd(Optional.empty(), how, Optional.empty());
        return machine.fire(event);
    }

    private void setEnd(Optional<StationEvent> word, UssdEnding how, Optional<SsError> why) {
        lastWord = word;
        ending = how;
        error = why;
    }

    @Override
    public void connected() {
        transaction = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        machine.fire(MobileUssdEvent.MM_CONNECTED);
    }

    @Override
    public void refused(RejectCause cause) {
        context.log().trace(Level.INFO, "USSD: the network refuses the connection, {0}", cause.title());
        end(MobileUssdEvent.MM_REFUSED, UssdEnding.NO_SERVICE);
    }

    @Override
    public void lost() {
        end(MobileUssdEvent.RADIO_LOST, UssdEnding.NO_SERVICE);
    }

    public void arrived(SupplementaryService message) {
        boolean isOurs = machine.accepts(MobileUssdEvent.NETWORK_ENDS)
                && message.transaction().answered().equals(transaction);
        if (message instanceof SsRegister register) {
            began(register, isOurs);
        } else if (!isOurs) {
            refuseUnknown(message);
        } else if (message instanceof SsFacility facility) {
            continued(facility.facility());
        } else {
            ended((SsReleaseComplete) message);
        }
    }

    private void began(SsRegister register, boolean isKnown) {
        TransactionIdentifier answered = register.transaction().answered();
        if (isKnown || register.transaction().fromOtherSide()) {
            context.radio().send(new SsReleaseComplete(answered, Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE));
            return;
        }
        Component answer = begin(register, answered);
        if (answer != null) {
            context.radio().send(new SsReleaseComplete(answered, ComponentCodec.encode(answer)));
        }
    }

    /** @return the final component of a refused dialogue; null if it has begun */
    private Component begin(SsRegister register, TransactionIdentifier answered) {
        try {
            Component component = ComponentCodec.decode(register.facility());
            if (!(component instanceof Invoke invoke)) {
                return new Reject(Optional.empty(), SsProblem.UNRECOGNIZED_COMPONENT);
            }
            if (machine.state() != MobileUssdState.IDLE) {
                return new ReturnError(invoke.id(), SsError.USSD_BUSY);
            }
            transaction = answered;
            return asked(invoke).orElse(null);
        } catch (ComponentFault fault) {
            return fault.answer();
        }
    }

    private void continued(OctetString facility) {
        Optional<Component> refusal;
        try {
            refusal = ComponentCodec.decode(facility) instanceof Invoke invoke ? asked(invoke) : Optional.empty();
        } catch (ComponentFault fault) {
            refusal = Optional.of(fault.answer());
        }
        refusal.ifPresent(this::sendFacility);
    }

    /** @return the answer to an operation that is not performed */
    private Optional<Component> asked(Invoke invoke) {
        boolean isRequest = invoke.is(SsOperation.UNSTRUCTURED_SS_REQUEST);
        if (!isRequest && !invoke.is(SsOperation.UNSTRUCTURED_SS_NOTIFY)) {
            return Optional.of(new Reject(Optional.of(invoke.id()), SsProblem.UNRECOGNIZED_OPERATION));
        }
        UssdText text;
        try {
            text = UssdText.decode(invoke.argument());
        } catch (ProtocolViolation violation) {
            context.log().trace(Level.WARNING, "USSD: {0}", violation.getMessage());
            return Optional.of(new Reject(Optional.of(invoke.id()), SsProblem.MISTYPED_PARAMETER));
        }
        if (text.coding().alphabet() == Alphabet.OCTETS) {
            return Optional.of(new ReturnError(invoke.id(), SsError.UNKNOWN_ALPHABET));
        }
        MobileUssdEvent event = isRequest ? MobileUssdEvent.NETWORK_ASKS : MobileUssdEvent.NETWORK_NOTIFIES;
        if (!machine.accepts(event)) {
            return Optional.of(new ReturnError(invoke.id(), SsError.USSD_BUSY));
        }
        shown = text.text();
        asked = invoke;
        machine.fire(event);
        return Optional.empty();
    }

    private void ended(SsReleaseComplete release) {
        setEnd(
                Optional.empty(),
                transaction.fromOtherSide() && release.cause().isEmpty()
                        ? UssdEnding.COMPLETED
                        : UssdEnding.ENDED_BY_NETWORK,
                Optional.empty());
        release.facility().ifPresent(this::readEnd);
        machine.fire(MobileUssdEvent.NETWORK_ENDS);
    }

    private void readEnd(OctetString facility) {
        try {
            Component last = ComponentCodec.decode(facility);
            if (last instanceof ReturnResult result) {
                Optional<StationEvent> word =
                        result.result().length() == 0 ? Optional.empty() : Optional.of(wordOf(result.result()));
                setEnd(word, UssdEnding.COMPLETED, Optional.empty());
            } else if (last instanceof ReturnError returned) {
                setEnd(Optional.empty(), UssdEnding.REFUSED, SsError.ofCode(returned.error()));
            } else if (last instanceof Reject) {
                setEnd(Optional.empty(), UssdEnding.REFUSED, Optional.empty());
            }
        } catch (ComponentFault | ProtocolViolation broken) {
            context.log().trace(Level.WARNING, "USSD: the last component is broken, {0}", broken.getMessage());
        }
    }

    /** A text, or the state of the supplementary service that the user asked about. */
    private StationEvent wordOf(OctetString result) throws ProtocolViolation {
        if (!(typed instanceof Invoke request) || request.is(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST)) {
            return new StationEvent.UssdReceived(UssdText.decode(result).text(), false);
        }
        SsOperation operation = SsOperation.ofCode(request.operation()).orElseThrow();
        int code = SsArgument.decode(request.argument()).service();
        SsCode service = SsCode.ofCode(code)
                .orElseThrow(() -> ProtocolViolation.invalid(String.format("service 0x%02x is not known", code)));
        return new StationEvent.ServiceAnswered(operation, ServiceStatus.decode(service, operation, result));
    }

    /** TS 24.010, 4.2.3: the answer to a message of an unknown transaction, except to the end of one. */
    private void refuseUnknown(SupplementaryService message) {
        context.log().trace(Level.DEBUG, "{0} of an unknown transaction", message);
        if (!(message instanceof SsReleaseComplete)) {
            context.radio()
                    .send(new SsReleaseComplete(
                            message.transaction().answered(), Cause.INVALID_TRANSACTION_IDENTIFIER));
        }
    }

    private void perform(MobileUssdAction action) {
        switch (action) {
            case REQUEST_CONNECTION -> services.request(ServiceType.SUPPLEMENTARY_SERVICE);
            case ADOPT_CONNECTION -> services.adopt(ServiceType.SUPPLEMENTARY_SERVICE);
            case RELEASE_CONNECTION -> services.release(ServiceType.SUPPLEMENTARY_SERVICE);
            case SEND_REQUEST -> sendRequest();
            case SEND_REPLY -> sendFacility(typed);
            case SEND_CONFIRMATION -> sendFacility(new ReturnResult(asked.id()));
            case SEND_RELEASE_COMPLETE -> context.radio().send(new SsReleaseComplete(transaction));
            case START_WAIT ->
                context.timers()
                        .start(
                                StationTimer.SERVICE_WAIT,
                                () -> end(MobileUssdEvent.WAIT_EXPIRED, UssdEnding.NO_SERVICE));
            case START_ANSWER ->
                context.timers()
                        .start(
                                StationTimer.SERVICE_ANSWER,
                                () -> end(MobileUssdEvent.ANSWER_EXPIRED, UssdEnding.NO_ANSWER));
            case STOP_TIMERS -> context.timers().stop(StationTimer.SERVICE_WAIT, StationTimer.SERVICE_ANSWER);
            case SHOW_TEXT -> context.events().add(new StationEvent.UssdReceived(shown, awaitsReply()));
            case REPORT_END ->
                context.events().add(lastWord.orElseGet(() -> new StationEvent.UssdEnded(ending, error)));
        }
    }

    private void sendRequest() {
        context.radio()
                .send(new SsRegister(transaction, ComponentCodec.encode(typed), Optional.of(SsRegister.PHASE_2)));
    }

    private void sendFacility(Component component) {
        context.radio().send(new SsFacility(transaction, ComponentCodec.encode(component)));
    }
}
