package simgsm.lesson;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.UnaryOperator;

/**
 * A test of one field of an event, as {@code cause=16|17}, {@code x>=4.2}, {@code number=697+-1.5%} or {@code text~#**20}, or of a
 * kept value when the event comes, as {@code {cell}=east}.
 *
 * @param field of the event, or a name in braces
 * @param value as written; names in braces are replaced at each test
 */
public record FieldTest(String field, String operator, String value) {
    private static final List<String> OPERATORS = List.of("!=", ">=", "<=", "=", ">", "<", "~");
    private static final String TOLERANCE = "+-";
    private static final double PERCENT = 100;

    /** @throws LessonException if there is no operator */
    static FieldTest parse(String word) throws LessonException {
        int at = word.startsWith("{") ? word.indexOf('}') + 1 : 0;
        while (at < word.length() && (Character.isLetterOrDigit(word.charAt(at)) || word.charAt(at) == '-')) {
            at++;
        }
        String rest = word.substring(at);
        for (String operator : OPERATORS) {
            if (at > 0 && rest.startsWith(operator)) {
                return new FieldTest(word.substring(0, at), operator, rest.substring(operator.length()));
            }
        }
        throw new LessonException("expected FIELD and one of " + String.join(" ", OPERATORS) + ", found " + word);
    }

    /** True if the fields pass; a missing field or value fails, except for {@code !=}. */
    boolean isPassedBy(Map<String, String> fields, UnaryOperator<String> variables) {
        String found = field.startsWith("{") ? known(variables.apply(field)) : fields.get(field);
        String wanted = known(variables.apply(value));
        if (found == null || wanted == null) {
            return operator.equals("!=");
        }
        return switch (operator) {
            case "=" -> isOneOf(found, wanted);
            case "!=" -> !isOneOf(found, wanted);
            case "~" -> plain(found).contains(plain(wanted));
            default -> compare(found, wanted);
        };
    }

    /** Null while a name in braces has no value yet, so that an answer cannot be right by naming it. */
    private static String known(String replaced) {
        return LessonVariables.namesIn(replaced).isEmpty() ? replaced : null;
    }

    private static boolean isOneOf(String found, String wanted) {
        for (String each : wanted.split("\\|", -1)) {
            int tolerance = each.indexOf(TOLERANCE);
            boolean equal = tolerance > 0
                    ? isNear(found, each.substring(0, tolerance), each.substring(tolerance + TOLERANCE.length()))
                    : plain(found).equals(plain(each));
            if (equal) {
                return true;
            }
        }
        return false;
    }

    private static boolean isNear(String found, String wanted, String tolerance) {
        double middle = number(wanted);
        double most = tolerance.endsWith("%")
                ? Math.abs(middle) * number(tolerance.substring(0, tolerance.length() - 1)) / PERCENT
                : number(tolerance);
        return Math.abs(number(found) - middle) <= most;
    }

    private boolean compare(String found, String wanted) {
        double left = number(found);
        double right = number(wanted);
        return switch (operator) {
            case ">" -> left > right;
            case "<" -> left < right;
            case ">=" -> left >= right;
            default -> left <= right;
        };
    }

    /** NaN, for which every comparison is false, if the text is no number. */
    private static double number(String text) {
        try {
            return Double.parseDouble(text.strip().replace(',', '.'));
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    /** Without blanks and in small letters, which do not affect an answer's correctness. */
    static String plain(String text) {
        return text.replaceAll("\\s+", "").toLowerCase(Locale.ROOT);
    }
}
