package simrobot.ui.inspector;

import simgsm.console.TextBundle;
import simrobot.control.LoggedEvent;
import simrobot.control.RobotEvent;
import simrobot.drawing.NumberTexts;
import simrobot.ui.StatusLamps;

/** Logged events in words. */
public final class EventTexts {
    private final TextBundle texts;

    public EventTexts(TextBundle texts) {
        this.texts = texts;
    }

    public String of(RobotEvent event) {
        if (event instanceof RobotEvent.Added added) {
            return texts.of("log.added", added.number());
        } else if (event instanceof RobotEvent.Removed) {
            return texts.of("log.removed");
        } else if (event instanceof RobotEvent.Registered registered) {
            return texts.of("log.registered", registered.number());
        } else if (event instanceof RobotEvent.Unregistered) {
            return texts.of("log.unregistered");
        } else if (event instanceof RobotEvent.ModemChanged modem) {
            return texts.of("log.modem." + modem.word(), modem.text());
        } else if (event instanceof RobotEvent.CallRinging ringing) {
            return texts.of("log.ringing", caller(ringing.from()));
        } else if (event instanceof RobotEvent.CallReceived call) {
            return texts.of("log.call", caller(call.from()));
        } else if (event instanceof RobotEvent.OrderVerified order) {
            return texts.of("log.order", order.keys(), verdict(order.verdict()));
        } else if (event instanceof RobotEvent.OrderAnswered answer) {
            return texts.of("log.outcome", String.valueOf(answer.tone()), answer.text());
        } else if (event instanceof RobotEvent.ReplySent reply) {
            return texts.of("log.reply", reply.to(), reply.text());
        } else if (event instanceof RobotEvent.ReplyFailed reply) {
            return texts.of("log.reply.failed", reply.to(), reply.text());
        } else if (event instanceof RobotEvent.BatteryChanged battery) {
            return texts.of(battery.isLow() ? "log.battery.low" : "log.battery.ok");
        } else if (event instanceof RobotEvent.MessageReceived message) {
            return texts.of("log.message", message.from(), message.text());
        } else if (event instanceof RobotEvent.UssdAnswered ussd) {
            return texts.of("log.ussd", ussd.text(), ussd.reply());
        } else if (event instanceof RobotEvent.CallIdle idle) {
            return texts.of("log.idle", String.valueOf(idle.seconds()));
        } else if (event instanceof RobotEvent.CallReleased released) {
            return texts.of("log.released", String.valueOf(released.cause()));
        } else if (event instanceof RobotEvent.BehaviourChanged behaviour) {
            return texts.of("log.behaviour", RobotsCard.word(texts, behaviour.kind()));
        } else if (event instanceof RobotEvent.ClientMessage message) {
            return texts.of("log.client.message", message.text());
        } else if (event instanceof RobotEvent.TypeUnknown unknown) {
            return texts.of("log.type.unknown", unknown.type());
        } else if (event instanceof RobotEvent.BehaviourFailed failed) {
            return texts.of("log.behaviour.failed", failed.name(), String.valueOf(failed.line()), failed.text());
        } else if (event instanceof RobotEvent.StatusChanged status) {
            return StatusLamps.word(texts, status.status());
        }
        throw new IllegalArgumentException("not an event of the log: " + event);
    }

    private String caller(String from) {
        return from.isEmpty() ? texts.of("order.from.unknown") : from;
    }

    private String verdict(String word) {
        return switch (word) {
            case "accepted" -> texts.of("log.verdict.accepted");
            case "refused" -> texts.of("log.verdict.refused");
            default -> texts.of("log.verdict.invalid");
        };
    }

    /** A line for the clipboard: time, robot and text, separated by tabs. */
    String line(LoggedEvent event) {
        return NumberTexts.clock(event.timeNanos()) + "\t" + event.robot() + "\t" + of(event.event());
    }
}
