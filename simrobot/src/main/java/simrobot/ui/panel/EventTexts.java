package simrobot.ui.panel;

import simgsm.console.TextBundle;
import simrobot.behaviour.BehaviourKind;
import simrobot.control.LoggedEvent;
import simrobot.drawing.NumberTexts;
import simrobot.ui.StatusLamps;
import vericommand.RobotStatus;

/** Logged events as people read them. */
final class EventTexts {
    private final TextBundle texts;

    EventTexts(TextBundle texts) {
        this.texts = texts;
    }

    String of(LoggedEvent event) {
        String what = event.what();
        return switch (event.kind()) {
            case ADDED -> texts.of("log.added", what);
            case REMOVED -> texts.of("log.removed");
            case REGISTERED -> texts.of("log.registered", what);
            case UNREGISTERED -> texts.of("log.unregistered");
            case CALL -> texts.of("log.call", what.isEmpty() ? texts.of("order.from.unknown") : what);
            case ORDER -> texts.of("log.order", what, verdict(event.text()));
            case OUTCOME -> texts.of("log.outcome", what, event.text());
            case REPLY -> texts.of("log.reply", what, event.text());
            case MESSAGE -> texts.of("log.message", what, event.text());
            case RELEASED -> texts.of("log.released", what);
            case BEHAVIOUR -> texts.of("log.behaviour", RobotsCard.word(texts, BehaviourKind.valueOf(what)));
            case STATUS -> StatusLamps.word(texts, RobotStatus.valueOf(what));
        };
    }

    private String verdict(String word) {
        return switch (word) {
            case "accepted" -> texts.of("log.verdict.accepted");
            case "refused" -> texts.of("log.verdict.refused");
            default -> texts.of("log.verdict.invalid");
        };
    }

    /** A line for other programs: time, robot, text. */
    String line(LoggedEvent event) {
        return NumberTexts.clock(event.timeNanos()) + "\t" + event.robot() + "\t" + of(event);
    }
}
