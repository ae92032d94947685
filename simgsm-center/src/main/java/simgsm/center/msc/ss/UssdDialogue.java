package simgsm.center.msc.ss;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.msc.link.PagedTransaction;
import simgsm.center.msc.ss.UssdDialogueTable.UssdAction;
import simgsm.center.msc.ss.UssdDialogueTable.UssdEvent;
import simgsm.center.msc.ss.UssdDialogueTable.UssdState;
import simgsm.octets.OctetString;
import simgsm.ss.Component;
import simgsm.ss.Component.Invoke;
import simgsm.ss.Component.Reject;
import simgsm.ss.Component.ReturnError;
import simgsm.ss.Component.ReturnResult;
import simgsm.ss.ComponentCodec;
import simgsm.ss.ComponentFault;
import simgsm.ss.SsError;
import simgsm.ss.SsOperation;
import simgsm.ss.SsProblem;
import simgsm.ss.UssdText;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;

/** One USSD dialogue with a mobile: {@link UssdDialogueTable} driven by the mobile, a service and a timer. */
final class UssdDialogue implements PagedTransaction, UssdSession {
    private static final int INVOKE_IDS = 128;

    private final Link link;
    private final TransactionIdentifier transaction;
    private final Consumer<UssdDialogue> ended;
    private final StateMachine<UssdState, UssdEvent, UssdAction> machine;
    /** Invoke identifier of the mobile's request; empty if the network began the dialogue. */
    private final Optional<Integer> request;
    /** Receives the outcome of a question that the network began. */
    private Consumer<UssdOutcome> told = outcome -> {};
    /** Receives the reply to the current question. */
    private Consumer<String> reply = text -> {};

    private UssdText question;
    private int questionId;
    private String replied = "";
    private UssdOutcome.Kind failure = UssdOutcome.Kind.ABSENT;
    /** The component of RELEASE COMPLETE. */
    private Optional<Component> last = Optional.empty();

    private Optional<Cause> cause = Optional.empty();
    private Timer replyTimer;

    private UssdDialogue(
            Link link,
            TransactionIdentifier transaction,
            Optional<Integer> request,
            UssdState initial,
            Consumer<UssdDialogue> ended) {
        this.link = link;
        this.transaction = transaction;
        this.request = request;
        this.ended = ended;
        machine = new StateMachine<>(UssdDialogueTable.ROWS, link, this::perform, initial);
    }

    /** Creates a dialogue that the mobile has begun by this operation. */
    static UssdDialogue ofMobile(
            Link link, TransactionIdentifier transaction, Invoke request, Consumer<UssdDialogue> ended) {
        return new UssdDialogue(link, transaction, Optional.of(request.id()), UssdState.IN_SERVICE, ended);
    }

    /** Creates a dialogue that the network begins with a question, once the mobile is paged. */
    static UssdDialogue ofNetwork(
            Link link,
            TransactionIdentifier transaction,
            String question,
            Consumer<UssdOutcome> told,
            Consumer<UssdDialogue> ended) {
        UssdDialogue begun = new UssdDialogue(link, transaction, Optional.empty(), UssdState.PAGING, ended);
        begun.question = UssdText.of(question);
        begun.told = told;
        begun.reply = text -> {
            begun.told.accept(new UssdOutcome(UssdOutcome.Kind.REPLIED, text));
            begun.machine.fire(UssdEvent.SERVICE_ENDS);
        };
        return begun;
    }

    /**
     * Adds a receiver of the question's outcome.
     *
     * @return false if this dialogue has another question
     */
    boolean join(String sameQuestion, Consumer<UssdOutcome> alsoTold) {
        boolean isSame = question.text().equals(sameQuestion);
        if (isSame) {
            told = told.andThen(alsoTold);
        }
        return isSame;
    }

    TransactionIdentifier transaction() {
        return transaction;
    }

    boolean needsRadio() {
        return machine.state() != UssdState.PAGING;
    }

    @Override
    public void radioConnected() {
        machine.fire(UssdEvent.RADIO_CONNECTED);
    }

    @Override
    public void pagingFailed() {
        machine.fire(UssdEvent.PAGING_FAILED);
    }

    void radioLost() {
        failure = UssdOutcome.Kind.ABSENT;
        machine.fire(UssdEvent.RADIO_LOST);
    }

    // The service's side.

    @Override
    public Msisdn subscriber() {
        return link.subscriber().number();
    }

    @Override
    public void ask(String text, Consumer<String> newReply) {
        if (machine.accepts(UssdEvent.SERVICE_ASKS)) {
            question = UssdText.of(text);
            questionId = (questionId + 1) % INVOKE_IDS;
            reply = newReply;
            machine.fire(UssdEvent.SERVICE_ASKS);
        }
    }

    @Override
    public void end(String text) {
        end(id -> new ReturnResult(
                id,
                SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST,
                UssdText.of(text).encode()));
    }

    @Override
    public void fail(SsError error) {
        end(id -> new ReturnError(id, error));
    }

    private void end(IntFunction<Component> answer) {
        if (machine.accepts(UssdEvent.SERVICE_ENDS)) {
            last = request.map(answer::apply);
            machine.fire(UssdEvent.SERVICE_ENDS);
        }
    }

    // The mobile's side.

    void receive(SsFacility message) {
        read(message.facility());
    }

    /** Handles the mobile's end of the dialogue; its last component may be the reply. */
    void receive(SsReleaseComplete message) {
        failure = UssdOutcome.Kind.REFUSED;
        message.facility().ifPresent(facility -> {
            try {
                Component component = ComponentCodec.decode(facility);
                if (component instanceof ReturnError error && error.error() == SsError.USSD_BUSY.code()) {
                    failure = UssdOutcome.Kind.BUSY;
                }
            } catch (ComponentFault fault) {
                link.violated(fault.getMessage());
            }
        });
        machine.fire(UssdEvent.MOBILE_ENDS);
    }

    private void read(OctetString facility) {
        try {
            Component component = ComponentCodec.decode(facility);
            if (component instanceof Invoke invoke) {
                send(new Reject(Optional.of(invoke.id()), SsProblem.UNRECOGNIZED_OPERATION));
            } else if (component instanceof ReturnResult result) {
                readReply(result);
            } else if (component instanceof ReturnError error && error.id() == questionId) {
                refused(error.error() == SsError.USSD_BUSY.code() ? UssdOutcome.Kind.BUSY : UssdOutcome.Kind.REFUSED);
            } else if (component instanceof Reject) {
                refused(UssdOutcome.Kind.REFUSED);
            }
        } catch (ComponentFault fault) {
            link.violated(fault.getMessage());
            send(fault.answer());
        }
    }

    private void readReply(ReturnResult result) {
        if (result.id() != questionId || !machine.accepts(UssdEvent.REPLIED)) {
            send(new Reject(Optional.of(result.id()), SsProblem.RESULT_OF_UNKNOWN_INVOKE));
            return;
        }
        try {
            replied = result.result().length() == 0
                    ? ""
                    : UssdText.decode(result.result()).text();
            machine.fire(UssdEvent.REPLIED);
        } catch (ProtocolViolation violation) {
            link.violated(violation.getMessage());
            send(new Reject(Optional.of(result.id()), SsProblem.RESULT_MISTYPED));
        }
    }

    private void refused(UssdOutcome.Kind kind) {
        failure = kind;
        last = request.map(id -> new ReturnError(id, SsError.SYSTEM_FAILURE));
        machine.fire(UssdEvent.REPLY_REFUSED);
    }

    private void replyExpired() {
        failure = UssdOutcome.Kind.NO_REPLY;
        cause = Optional.of(Cause.RECOVERY_ON_TIMER_EXPIRY);
        machine.fire(UssdEvent.REPLY_EXPIRED);
    }

    private void perform(UssdAction action) {
        switch (action) {
            case SEND_REGISTER -> link.send(new SsRegister(transaction, questionOctets(), Optional.empty()));
            case SEND_FACILITY -> link.send(new SsFacility(transaction, questionOctets()));
            case SEND_RELEASE_COMPLETE ->
                link.send(new SsReleaseComplete(transaction, cause, last.map(ComponentCodec::encode)));
            case START_REPLY_TIMER ->
                replyTimer = link.timers().start(NetworkTimer.USSD_REPLY.nanos(), this::replyExpired);
            case STOP_REPLY_TIMER -> link.timers().cancel(replyTimer);
            case TELL_REPLY -> reply.accept(replied);
            case TELL_FAILURE -> told.accept(UssdOutcome.of(failure));
            case END -> {
                link.paging().cancel(this);
                ended.accept(this);
            }
        }
    }

    private OctetString questionOctets() {
        return ComponentCodec.encode(new Invoke(questionId, SsOperation.UNSTRUCTURED_SS_REQUEST, question.encode()));
    }

    private void send(Component component) {
        link.send(new SsFacility(transaction, ComponentCodec.encode(component)));
    }
}
