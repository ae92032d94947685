package simgsm.center.msc.ss;

import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.center.subscriber.CallServices;
import simgsm.center.subscriber.Subscriber;
import simgsm.ss.Component;
import simgsm.ss.Component.Invoke;
import simgsm.ss.Component.Reject;
import simgsm.ss.Component.ReturnError;
import simgsm.ss.Component.ReturnResult;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsArgument;
import simgsm.ss.SsCode;
import simgsm.ss.SsError;
import simgsm.ss.SsOperation;
import simgsm.ss.SsProblem;

/**
 * Operations on a subscriber's call forwarding and call waiting (TS 23.082, 1.1; TS 23.083, 1.1), and interrogation of
 * line identification (TS 23.081).
 */
final class ServiceProcedures {
    private static final Set<SsOperation> OPERATIONS = Set.of(
            SsOperation.REGISTER_SS,
            SsOperation.ERASE_SS,
            SsOperation.ACTIVATE_SS,
            SsOperation.DEACTIVATE_SS,
            SsOperation.INTERROGATE_SS);

    /** The services of number presentation: all callers and answering parties show theirs. */
    private static final Set<SsCode> SHOWN =
            Set.of(SsCode.CALLING_LINE_PRESENTATION, SsCode.CONNECTED_LINE_PRESENTATION);

    private static final int SHOWN_ALWAYS = ServiceStatus.PROVISIONED | ServiceStatus.ACTIVE;

    private final boolean callWaiting;
    private final BiConsumer<Subscriber, Consumer<Boolean>> store;

    /**
     * Procedures for all subscribers.
     *
     * @param callWaiting default of call waiting
     * @param store stores the changed services of a subscriber, and reports their storage
     */
    ServiceProcedures(boolean callWaiting, BiConsumer<Subscriber, Consumer<Boolean>> store) {
        this.callWaiting = callWaiting;
        this.store = store;
    }

    /**
     * Performs an operation on a supplementary service.
     *
     * @param answer receives the answer once: to a change once it is stored, else at once
     * @return false if it is no such operation
     */
    boolean perform(Subscriber subscriber, Invoke invoke, Consumer<Component> answer) {
        Optional<SsOperation> operation = SsOperation.ofCode(invoke.operation()).filter(OPERATIONS::contains);
        operation.ifPresent(known -> perform(subscriber, invoke, known, answer));
        return operation.isPresent();
    }

    private void perform(Subscriber subscriber, Invoke invoke, SsOperation operation, Consumer<Component> answer) {
        CallServices services = subscriber.services();
        String before = services.text();
        Component done = perform(subscriber, invoke, operation);
        if (operation == SsOperation.INTERROGATE_SS || !(done instanceof ReturnResult)) {
            answer.accept(done);
            return;
        }
        store.accept(subscriber, isStored -> {
            if (!isStored) {
                services.restore(before);
            }
            answer.accept(isStored ? done : new ReturnError(invoke.id(), SsError.SYSTEM_FAILURE));
        });
    }

    private Component perform(Subscriber subscriber, Invoke invoke, SsOperation operation) {
        SsArgument argument;
        try {
            argument = SsArgument.decode(invoke.argument());
        } catch (ProtocolViolation violation) {
            return new Reject(Optional.of(invoke.id()), SsProblem.MISTYPED_PARAMETER);
        }
        Optional<SsCode> service = SsCode.ofCode(argument.service());
        if (service.isEmpty()) {
            return new ReturnError(invoke.id(), SsError.FACILITY_NOT_SUPPORTED);
        }
        Optional<SsError> error = argument.refusal().isPresent()
                ? argument.refusal()
                : perform(subscriber, operation, service.get(), argument);
        if (error.isPresent()) {
            return new ReturnError(invoke.id(), error.get());
        }
        ServiceStatus status = status(subscriber.services(), service.get());
        return new ReturnResult(invoke.id(), operation, status.encode(operation));
    }

    private static Optional<SsError> perform(
            Subscriber subscriber, SsOperation operation, SsCode service, SsArgument argument) {
        if (service.isForwarding()) {
            return forward(subscriber, operation, service, argument);
        }
        if (service.isLineIdentification()) {
            // TS 23.081: these permit only interrogation
            return operation == SsOperation.INTERROGATE_SS
                    ? Optional.empty()
                    : Optional.of(SsError.ILLEGAL_SS_OPERATION);
        }
        return setWaiting(subscriber.services(), operation);
    }

    private static Optional<SsError> forward(
            Subscriber subscriber, SsOperation operation, SsCode service, SsArgument argument) {
        CallServices services = subscriber.services();
        switch (operation) {
            case REGISTER_SS -> {
                if (argument.forwardedTo().isEmpty()) {
                    return Optional.of(SsError.DATA_MISSING);
                }
                Msisdn to = Msisdn.parse(argument.forwardedTo().get());
                boolean isTimed = service.members().contains(SsCode.FORWARDING_ON_NO_REPLY);
                if (to.plain().equals(subscriber.number())
                        || !argument.noReplySeconds()
                                .map(seconds -> isTimed && isNoReplyTime(seconds))
                                .orElse(true)) {
                    return Optional.of(SsError.UNEXPECTED_DATA_VALUE);
                }
                argument.noReplySeconds().ifPresent(services::setNoReplySeconds);
                service.members().forEach(condition -> services.register(condition, to));
            }
            case ERASE_SS -> service.members().forEach(services::erase);
            case INTERROGATE_SS -> {
                return service.isGroup() ? Optional.of(SsError.ILLEGAL_SS_OPERATION) : Optional.empty();
            }
            default -> {
                boolean isActive = operation == SsOperation.ACTIVATE_SS;
                boolean isAny = false;
                for (SsCode condition : service.members()) {
                    isAny |= services.setForwarding(condition, isActive);
                }
                return isAny ? Optional.empty() : Optional.of(SsError.SS_ERROR_STATUS);
            }
        }
        return Optional.empty();
    }

    /** 5 to 30 s in steps of 5 (TS 22.082, 3). */
    private static boolean isNoReplyTime(int seconds) {
        return seconds >= 5 && seconds <= 30 && seconds % 5 == 0;
    }

    private static Optional<SsError> setWaiting(CallServices services, SsOperation operation) {
        switch (operation) {
            case ACTIVATE_SS -> services.setCallWaiting(true);
            case DEACTIVATE_SS -> services.setCallWaiting(false);
            case INTERROGATE_SS -> {}
            default -> {
                return Optional.of(SsError.ILLEGAL_SS_OPERATION);
            }
        }
        return Optional.empty();
    }

    /** The status of a service; of a group, that of its first service. */
    private ServiceStatus status(CallServices services, SsCode service) {
        if (service == SsCode.CALL_WAITING) {
            int active = services.hasCallWaiting(callWaiting) ? ServiceStatus.ACTIVE : 0;
            return new ServiceStatus(service, ServiceStatus.PROVISIONED | active, Optional.empty());
        }
        if (service.isLineIdentification()) {
            return new ServiceStatus(service, SHOWN.contains(service) ? SHOWN_ALWAYS : 0, Optional.empty());
        }
        ServiceStatus first = services.status(service.members().get(0));
        return new ServiceStatus(service, first.flags(), first.forwardedTo(), first.noReplySeconds());
    }
}
