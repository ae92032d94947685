package simgsm.modem.at;

/** The format of answers (V.250, 6.2). Initially with echo, in words and without error numbers. */
public final class AtFormat {
    private boolean isEchoed = true;
    private boolean isInWords = true;
    private boolean isQuiet;
    private int errorMode;

    AtFormat() {}

    public boolean isEchoed() {
        return isEchoed;
    }

    /** ATE. */
    public void setEchoed(boolean echoed) {
        isEchoed = echoed;
    }

    /** ATV. */
    public void setInWords(boolean inWords) {
        isInWords = inWords;
    }

    /** ATQ: without result codes. */
    public void setQuiet(boolean quiet) {
        isQuiet = quiet;
    }

    public int errorMode() {
        return errorMode;
    }

    /** AT+CMEE: 0 for ERROR, 1 for numbers, 2 for words. */
    public void setErrorMode(int newMode) {
        errorMode = newMode;
    }

    /** The settings in the form of AT&V. */
    public String describe() {
        return "E" + digit(isEchoed) + " V" + digit(isInWords) + " Q" + digit(isQuiet) + " +CMEE: " + errorMode;
    }

    private static int digit(boolean set) {
        return set ? 1 : 0;
    }

    String line(String information) {
        return (isInWords ? "\r\n" : "") + information + "\r\n";
    }

    /** The text of a result; empty if result codes are suppressed. */
    String result(AtResult result) {
        if (isQuiet) {
            return "";
        }
        String text = result.text(isInWords, errorMode);
        return isInWords ? "\r\n" + text + "\r\n" : text + "\r";
    }
}
