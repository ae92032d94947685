package simrobot.ui.panel;

import java.util.List;
import java.util.Optional;
import vericommand.Pose;

/** What a new robot is called and where it stands, from what people type. */
final class NewRobot {
    private static final String FIRST_NUMBER = "5550200";

    private NewRobot() {}

    static String freeName(List<String> taken) {
        int count = taken.size() + 1;
        while (taken.contains("robot" + count)) {
            count++;
        }
        return "robot" + count;
    }

    /** The one after the highest. */
    static String freeNumber(List<String> taken) {
        return taken.stream()
                .filter(number -> number.matches("[0-9]{1,15}"))
                .map(Long::parseLong)
                .max(Long::compare)
                .map(highest -> String.valueOf(highest + 1))
                .orElse(FIRST_NUMBER);
    }

    /**
     * A place in metres and degrees; all empty is none, no heading is 0.
     *
     * @throws IllegalArgumentException with the word that is no number
     */
    static Optional<Pose> place(String x, String y, String heading) {
        if (x.isBlank() && y.isBlank() && heading.isBlank()) {
            return Optional.empty();
        }
        return Optional.of(new Pose(number(x), number(y), heading.isBlank() ? 0 : number(heading)));
    }

    /** A decimal with a dot or a comma. */
    private static double number(String word) {
        String text = word.strip().replace(',', '.');
        if (!text.matches("[-+]?([0-9]{1,7}(\\.[0-9]*)?|\\.[0-9]+)")) {
            throw new IllegalArgumentException(word.isBlank() ? "\"\"" : word.strip());
        }
        return Double.parseDouble(text);
    }
}
