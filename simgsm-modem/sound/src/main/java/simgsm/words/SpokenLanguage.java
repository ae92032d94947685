package simgsm.words;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** A language of the prompts, with its numbers and units. */
public enum SpokenLanguage {
    ENGLISH("en", Map.of("cm", "centimeters", "s", "seconds", "*", "star", "#", "hash"), List.of(), "to", "x", "y"),
    SPANISH(
            "es",
            Map.of("cm", "centímetros", "s", "segundos", "*", "asterisco", "#", "almohadilla", "x", "equis"),
            List.of("metro", "metros", "centímetro", "centímetros", "grado", "grados", "segundos"),
            "a",
            "equis",
            "i griega");

    /** Larger numbers are read digit by digit. */
    private static final int MOST = 9999;

    private static final List<String> ENGLISH_SMALL = List.of(
            "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen eighteen nineteen"
                    .split(" "));
    private static final List<String> ENGLISH_TENS =
            List.of("twenty thirty forty fifty sixty seventy eighty ninety".split(" "));
    private static final List<String> SPANISH_SMALL = List.of(
            ("cero uno dos tres cuatro cinco seis siete ocho nueve diez once doce trece catorce quince dieciséis diecisiete"
                            + " dieciocho diecinueve veinte veintiuno veintidós veintitrés veinticuatro veinticinco"
                            + " veintiséis veintisiete veintiocho veintinueve")
                    .split(" "));
    private static final List<String> SPANISH_TENS =
            List.of("treinta cuarenta cincuenta sesenta setenta ochenta noventa".split(" "));
    private static final Map<Integer, String> SPANISH_HUNDREDS =
            Map.of(1, "ciento", 5, "quinientos", 7, "setecientos", 9, "novecientos");

    private final String code;
    private final Map<String, String> abbreviations;
    private final List<String> masculine;
    private final String range;
    private final String x;
    private final String y;

    SpokenLanguage(
            String code, Map<String, String> abbreviations, List<String> masculine, String range, String x, String y) {
        this.code = code;
        this.abbreviations = abbreviations;
        this.masculine = masculine;
        this.range = range;
        this.x = x;
        this.y = y;
    }

    /** Spanish, or English for every other language. */
    public static SpokenLanguage of(Locale locale) {
        return locale.getLanguage().equals("es") ? SPANISH : ENGLISH;
    }

    /** ISO 639: {@code en} or {@code es}. */
    public String code() {
        return code;
    }

    /** The word for a unit or a key in a text; the text itself if it is no abbreviation. */
    String expand(String text) {
        return abbreviations.getOrDefault(text, text);
    }

    /** The word between the ends of a range. */
    String range() {
        return range;
    }

    /** The name of the first coordinate. */
    String x() {
        return x;
    }

    /** The name of the second coordinate. */
    String y() {
        return y;
    }

    /**
     * A number in words.
     *
     * @param number decimal digits, with a sign and a fraction or without; a fraction is read digit by digit, without
     *     zeros at its end
     * @param noun the counted word that follows; empty if none does
     */
    public List<String> number(String number, String noun) {
        List<String> words = new ArrayList<>();
        String unsigned = number.replaceFirst("^-", "");
        String whole = unsigned.replaceFirst("\\..*", "");
        String fraction =
                unsigned.contains(".") ? unsigned.replaceFirst("^[0-9]*\\.", "").replaceFirst("0+$", "") : "";
        if (number.startsWith("-") && unsigned.matches(".*[1-9].*")) {
            words.add(this == SPANISH ? "menos" : "minus");
        }
        if (whole.length() > 4 || Integer.parseInt(whole) > MOST) {
            words.addAll(digits(whole));
        } else {
            int value = Integer.parseInt(whole);
            words.addAll(this == SPANISH ? spanish(value, fraction.isEmpty() ? noun : "") : english(value));
        }
        if (!fraction.isEmpty()) {
            words.add(this == SPANISH ? "coma" : "point");
            words.addAll(digits(fraction));
        }
        return words;
    }

    private List<String> digits(String digits) {
        List<String> small = this == SPANISH ? SPANISH_SMALL : ENGLISH_SMALL;
        return digits.chars().mapToObj(digit -> small.get(digit - '0')).toList();
    }

    /** A length in words, rounded to centimetres: {@code two meters twenty}. @param meters decimal digits with a point */
    public List<String> meters(String meters) {
        long centimeters = Math.round(Math.abs(Double.parseDouble(meters)) * 100);
        List<String> words = new ArrayList<>();
        if (meters.startsWith("-") && centimeters > 0) {
            words.add(this == SPANISH ? "menos" : "minus");
        }
        long whole = centimeters / 100;
        long rest = centimeters % 100;
        if (whole > 0 || rest == 0) {
            words.addAll(amount(whole, this == SPANISH ? "metros" : "meters"));
        }
        if (whole > 0 && rest >= 10) {
            words.addAll(number("" + rest, ""));
        } else if (rest > 0) {
            words.addAll(amount(rest, expand("cm")));
        }
        return words;
    }

    /** A whole number with its unit, the unit in the singular after one. */
    List<String> amount(long value, String unit) {
        String noun = value == 1 ? unit.replaceFirst("s$", "") : unit;
        List<String> words = new ArrayList<>(number("" + value, noun));
        words.add(noun);
        return words;
    }

    private static List<String> english(int number) {
        List<String> words = new ArrayList<>();
        if (number >= 1000) {
            words.addAll(List.of(ENGLISH_SMALL.get(number / 1000), "thousand"));
        }
        int below = number % 1000;
        if (below >= 100) {
            words.addAll(List.of(ENGLISH_SMALL.get(below / 100), "hundred"));
        }
        int rest = below % 100;
        if (rest >= 20) {
            words.add(ENGLISH_TENS.get(rest / 10 - 2));
        }
        int last = rest < 20 ? rest : rest % 10;
        if (last > 0 || number == 0) {
            words.add(ENGLISH_SMALL.get(last));
        }
        return words;
    }

    private List<String> spanish(int number, String noun) {
        List<String> words = new ArrayList<>();
        if (number >= 2000) {
            words.add(SPANISH_SMALL.get(number / 1000));
        }
        if (number >= 1000) {
            words.add("mil");
        }
        int below = number % 1000;
        if (below == 100) {
            words.add("cien");
        } else if (SPANISH_HUNDREDS.containsKey(below / 100)) {
            words.add(SPANISH_HUNDREDS.get(below / 100));
        } else if (below > 100) {
            words.addAll(List.of(SPANISH_SMALL.get(below / 100), "-cientos"));
        }
        int rest = below % 100;
        if (rest >= 30) {
            words.add(SPANISH_TENS.get(rest / 10 - 3));
        }
        int last = rest < 30 ? rest : rest % 10;
        if (rest >= 30 && last > 0) {
            words.add("y");
        }
        if (last > 0 || number == 0) {
            words.add(agreeing(SPANISH_SMALL.get(last), noun));
        }
        return words;
    }

    /** {@code uno} before a noun: {@code un metro, una instrucción, veintiún grados}. */
    private String agreeing(String word, String noun) {
        if (noun.isEmpty() || !word.endsWith("uno")) {
            return word;
        }
        if (!masculine.contains(noun)) {
            return word.replaceFirst("o$", "a");
        }
        return word.equals("uno") ? "un" : "veintiún";
    }
}
