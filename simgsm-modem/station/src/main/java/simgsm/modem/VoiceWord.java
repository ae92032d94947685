package simgsm.modem;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.words.SpokenLanguage;

/** The words of voice commands, in the order of the enrolment. */
enum VoiceWord {
    FORWARD("forward", "adelante"),
    TURN("turn", "gira"),
    RIGHT("right", "derecha"),
    STOP("stop", "para"),
    STATUS("status", "estado"),
    YES("yes", "sí"),
    NO("no", "no"),
    ZERO("zero", "cero"),
    ONE("one", "uno"),
    TWO("two", "dos"),
    THREE("three", "tres"),
    FOUR("four", "cuatro"),
    FIVE("five", "cinco"),
    SIX("six", "seis"),
    SEVEN("seven", "siete"),
    EIGHT("eight", "ocho"),
    NINE("nine", "nueve");

    private final String english;
    private final String spanish;

    VoiceWord(String english, String spanish) {
        this.english = english;
        this.spanish = spanish;
    }

    /** The prompt that says the word. */
    String prompt(SpokenLanguage language) {
        return language == SpokenLanguage.SPANISH ? spanish : english;
    }

    /** The word's name among a speaker's templates. */
    String template() {
        return name().toLowerCase(Locale.ROOT);
    }

    static VoiceWord ofTemplate(String name) {
        return valueOf(name.toUpperCase(Locale.ROOT));
    }

    boolean isDigit() {
        return ordinal() >= ZERO.ordinal();
    }

    /** The words that may follow these in a command; none if it is complete. */
    static List<VoiceWord> after(List<VoiceWord> words) {
        if (words.isEmpty()) {
            return List.of(FORWARD, TURN, STOP, STATUS);
        }
        VoiceWord first = words.get(0);
        if (first == STOP || first == STATUS) {
            return List.of();
        }
        int digits = digits(words).length();
        boolean mayTurn = first == TURN && words.size() == 1;
        return Arrays.stream(values())
                .filter(word -> word.isDigit() && digits < 4 || word == RIGHT && mayTurn)
                .toList();
    }

    /** The order's keys; empty while a number is missing. */
    static Optional<String> keys(List<VoiceWord> words) {
        if (words.isEmpty()) {
            return Optional.empty();
        }
        String digits = digits(words);
        return switch (words.get(0)) {
            case STOP -> Optional.of("**###**");
            case STATUS -> Optional.of("**#*0**");
            case FORWARD -> digits.isEmpty() ? Optional.empty() : Optional.of("**#**" + digits + "**");
            default -> digits.isEmpty() ? Optional.empty() : Optional.of("**#*#" + digits + "**");
        };
    }

    private static String digits(List<VoiceWord> words) {
        StringBuilder digits = new StringBuilder();
        words.stream().filter(VoiceWord::isDigit).forEach(word -> digits.append(word.ordinal() - ZERO.ordinal()));
        return digits.toString();
    }
}
