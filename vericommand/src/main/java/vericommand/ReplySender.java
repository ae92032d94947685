package vericommand;

import java.util.function.Predicate;

/** Sends the replies to orders, by tone in a call, by SMS or to the program that gave them, and shows them in the window. */
final class ReplySender {
    private final Robot robot;
    private final VeriCommandSettings settings;
    private final VeriCommandListener listener;
    private final ReplyTexts texts;
    private final OrderDisplay display;
    private final Predicate<OrderOrigin> hasProcess;

    /** @param hasProcess true if a process started by this origin runs */
    ReplySender(
            Robot robot,
            VeriCommandSettings settings,
            VeriCommandListener listener,
            ReplyTexts texts,
            OrderDisplay display,
            Predicate<OrderOrigin> hasProcess) {
        this.robot = robot;
        this.settings = settings;
        this.listener = listener;
        this.texts = texts;
        this.display = display;
        this.hasProcess = hasProcess;
    }

    void send(OrderOrigin origin, Reply reply) {
        send(origin, reply, true);
    }

    /** @param byTone false for an order that {@code ###} stopped before its goal: it has no tone in a call */
    void send(OrderOrigin origin, Reply outcome, boolean byTone) {
        if (origin.isEnded()) {
            return;
        }
        Reply reply = robot.hasLowBattery() ? texts.withLowBattery(outcome) : outcome;
        show(reply);
        if (origin.source() == OrderSource.PROGRAM) {
            origin.answered(reply, !hasProcess.test(origin));
        } else if (origin.source() == OrderSource.MESSAGE) {
            if (settings.answered() != VeriCommandSettings.Answered.NONE) {
                listener.message(origin.from(), reply.message());
            }
        } else if (byTone) {
            listener.answer(reply);
            if (reply.tone() == ReplyTone.CONNECTION_DENIED) {
                listener.clearCall();
            }
        }
    }

    /** Answers an order that only asks. */
    void answerReport(OrderExecution question) {
        question.order().instructions().forEach(listener::instructionEnded);
        display.course(question.order(), OrderCourse.EXECUTED);
        send(question.origin(), texts.report(question.order(), robot.status(), robot.pose()));
    }

    /** Answers a stop order once the robot has stopped or is off. */
    void answerStop(OrderExecution stop) {
        stop.order().instructions().forEach(listener::instructionEnded);
        RobotStatus status = robot.status();
        boolean isOff = status == RobotStatus.DISCONNECTED;
        display.course(stop.order(), isOff ? OrderCourse.NOT_POSSIBLE : OrderCourse.EXECUTED);
        Reply reply = isOff
                ? texts.refused(ReplyTone.CONNECTION_DENIED, status)
                : texts.done(stop.order(), status, robot.pose());
        send(stop.origin(), reply);
    }

    /** Shows a reply that is not sent. */
    void show(Reply reply) {
        display.reply(reply);
        listener.outcome(reply);
    }
}
