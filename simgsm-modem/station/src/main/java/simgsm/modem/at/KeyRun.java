package simgsm.modem.at;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.dtmf.DtmfKey;

/** Consecutive keys of +VTS with the same length. */
public record KeyRun(List<DtmfKey> keys, int millis) {
    /** Length of keys without their own if +VTD sets none. */
    private static final int DEFAULT_MILLIS = 100;

    private static final int TENTH_MILLIS = 100;
    private static final int MOST_TENTHS = 255;
    /** In one +VTS. */
    private static final int MOST_KEYS = 64;

    private static final String KEY = "[0-9A-Da-d*#]";
    /** A key with its length (TS 27.007, C.2.11), keys in quotation marks with or without commas, or a key. */
    private static final Pattern ELEMENT =
            Pattern.compile("\\{(K),([0-9]{1,3})}|\"(K(?:,?K)*)\"|(K)".replace("K", KEY));

    private static final Pattern LIST = Pattern.compile("(?:%1$s)(?:,(?:%1$s))*".formatted(ELEMENT));

    /** @param tenths default length of keys, in 0.1 s; 0 for 100 ms */
    public static List<KeyRun> parse(String parameters, int tenths) throws AtException {
        String text = parameters.replace(" ", "").toUpperCase(Locale.ROOT);
        if (!LIST.matcher(text).matches()) {
            throw new AtException(CmeError.INCORRECT_PARAMETERS);
        }
        List<KeyRun> runs = new ArrayList<>();
        Matcher element = ELEMENT.matcher(text);
        while (element.find()) {
            boolean isTimed = element.group(2) != null;
            int length = isTimed ? Integer.parseInt(element.group(2)) : tenths;
            if (length > MOST_TENTHS) {
                throw new AtException(CmeError.INCORRECT_PARAMETERS);
            }
            String keys = isTimed ? element.group(1) : element.group().replaceAll("[\",]", "");
            add(runs, DtmfKey.sequence(keys), length == 0 ? DEFAULT_MILLIS : length * TENTH_MILLIS);
        }
        if (runs.stream().mapToInt(run -> run.keys.size()).sum() > MOST_KEYS) {
            throw new AtException(CmeError.INCORRECT_PARAMETERS);
        }
        return runs;
    }

    private static void add(List<KeyRun> runs, List<DtmfKey> keys, int millis) {
        if (!runs.isEmpty() && runs.get(runs.size() - 1).millis == millis) {
            runs.get(runs.size() - 1).keys.addAll(keys);
        } else {
            runs.add(new KeyRun(new ArrayList<>(keys), millis));
        }
    }
}
