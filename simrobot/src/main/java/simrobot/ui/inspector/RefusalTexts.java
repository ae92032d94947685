package simrobot.ui.inspector;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import simgsm.console.TextBundle;
import simrobot.control.Fleet;
import simrobot.process.BehaviourKind;
import simrobot.ui.SimRobotTexts;
import simrobot.ui.StatusLamps;
import simrobot.world.WorldFormatException;
import vericommand.RobotStatus;

/** Reasons for refusals and errors, in the window's language; logs and consoles have them in English. */
public final class RefusalTexts {
    private volatile TextBundle texts;

    public RefusalTexts(Locale language) {
        speak(language);
    }

    /** Sets the window's language; callable on any thread. */
    public void speak(Locale language) {
        texts = SimRobotTexts.in(language);
    }

    // ---- robots ----------------------------------------------------------------------------------------------------

    public String noNumber(String number) {
        return texts.of("refused.number.none", number);
    }

    public String noName(String name) {
        return texts.of("refused.name.none", name);
    }

    /** @param name of the robot that was not added */
    public String notAdded(String name, String number, Fleet.RobotRefusal refusal) {
        return switch (refusal.reason()) {
            case NUMBER_TAKEN -> texts.of("refused.number.taken", number);
            case NAME_TAKEN -> texts.of("refused.name.taken", name);
            case NO_CARD -> texts.of("refused.card", number);
            case PLACE_OUTSIDE -> texts.of("place.outside");
            case PLACE_TAKEN -> texts.of("place.occupied");
            case NO_PLACE -> texts.of("refused.full", name);
            case NOT_DONE -> texts.of("refused.late");
        };
    }

    public String late() {
        return texts.of("refused.late");
    }

    public String process(String robot, BehaviourKind kind, RobotStatus status) {
        return texts.of("refused.process", robot, RobotsCard.word(texts, kind), StatusLamps.word(texts, status));
    }

    /** The refusal of actions that a recording does not have. */
    public String onlyLookedAt() {
        return texts.of("refused.recording");
    }

    // ---- worlds and files ------------------------------------------------------------------------------------------

    public String tooSmall(String world) {
        return texts.of("refused.small", world);
    }

    /** @param where file and place of the damage */
    public String damaged(String where) {
        return texts.of("refused.damaged", where);
    }

    /** The reason why a world or a recording could not be read. */
    public String unreadable(Path file, IOException why) {
        if (why instanceof WorldFormatException fault) {
            return texts.of(
                    "refused.format",
                    fault.source(),
                    String.valueOf(fault.line()),
                    found(fault.found()),
                    fault.expected());
        }
        if (why instanceof NoSuchFileException) {
            return texts.of("refused.file.none", file);
        }
        if (why instanceof AccessDeniedException) {
            return texts.of("refused.file.unreadable", file);
        }
        return texts.of("refused.file.other", file, reason(why));
    }

    private String found(String words) {
        return switch (words) {
            case "the end of the line" -> texts.of("refused.format.line");
            case "the end of the file" -> texts.of("refused.format.file");
            case "a quote that is not closed" -> texts.of("refused.format.quote");
            default -> words;
        };
    }

    /** The reason why a file could not be written. */
    public String unwritable(Path file, IOException failure) {
        IOException why = failure.getCause() instanceof IOException cause ? cause : failure;
        if (Files.isDirectory(file)) {
            return texts.of("refused.file.folder", file);
        }
        Path folder = file.toAbsolutePath().getParent();
        if (why instanceof NoSuchFileException || folder != null && !Files.isDirectory(folder)) {
            return texts.of("refused.file.nowhere", file);
        }
        if (why instanceof AccessDeniedException || Files.exists(file) && !Files.isWritable(file)) {
            return texts.of("refused.file.protected", file);
        }
        return texts.of("refused.file.other", file, reason(why));
    }

    /** The operating system's message without the file's name. */
    private static String reason(IOException why) {
        boolean hasReason = why instanceof FileSystemException system && system.getReason() != null;
        return hasReason ? ((FileSystemException) why).getReason() : String.valueOf(why.getMessage());
    }
}
