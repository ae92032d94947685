package simgsm.center.msc;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.smsc.MessageState;
import simgsm.event.EventLine;
import simgsm.lesson.StepResult;

/** An event for the operator. */
public sealed interface ExchangeEvent {
    /** A subscriber has registered. */
    @EventLine("attached number=")
    record Attached(Msisdn number) implements ExchangeEvent {}

    /** A subscriber is no longer attached. */
    @EventLine("detached number=")
    record Detached(Msisdn number) implements ExchangeEvent {}

    /**
     * A call is initiated, alerting, active or released.
     *
     * @param id increasing from 1 in the order of SETUP
     * @param cause of the release; empty before
     */
    @EventLine("call from= to= state=")
    record CallChanged(long id, Msisdn from, Msisdn to, CallProgress state, Optional<Cause> cause)
            implements ExchangeEvent {}

    /** A subscriber has said the user's name: 1 to 30 characters. */
    @EventLine("named number= name=")
    record Named(Msisdn number, String name) implements ExchangeEvent {}

    /** A student's result in a step of a lesson, pass or fail. */
    @EventLine("lesson-result number= lesson=result.lesson step=result.step result=result.word tries=result.tries"
            + " hints=result.hints")
    record LessonResult(Msisdn number, StepResult result) implements ExchangeEvent {}

    /** A short message is accepted, delivered, expired, rejected or deleted. */
    @EventLine("sms id= from=from.digits to=to.digits state=")
    record MessageChanged(long id, Msisdn from, Msisdn to, MessageState state) implements ExchangeEvent {}
}
