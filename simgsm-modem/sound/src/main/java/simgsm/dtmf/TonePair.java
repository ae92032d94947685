package simgsm.dtmf;

/** One row's and one column's tone in three blocks of the {@link GoertzelBank}, each without the leakage of the other. */
final class TonePair {
    private static final GoertzelBank.Window WINDOW = new GoertzelBank.Window(0.25, 0.5, 0.25);

    int row;
    int column;
    double rowReal;
    double rowImaginary;
    double columnReal;
    double columnImaginary;

    private double leak;
    private double scale;

    void tuneTo(int key) {
        row = key / 4;
        column = key % 4;
        leak = leak(GoertzelBank.HERTZ[4 + column] - GoertzelBank.HERTZ[row]);
        scale = 1 / (1 - leak * leak);
    }

    /** Gain for a sine at a distance from its tone. */
    static double leak(double hertz) {
        double cosine = Math.cos(Math.PI * hertz / GoertzelBank.HOPS_PER_SECOND);
        return GoertzelBank.leak(hertz) * cosine * cosine;
    }

    /** Measures the three blocks up to one. @return geometric mean of both tones' amplitudes times their gains */
    double measure(GoertzelBank bank, long hop) {
        bank.measure(row, hop, WINDOW);
        double a = bank.real;
        double b = bank.imaginary;
        bank.measure(4 + column, hop, WINDOW);
        double c = bank.real;
        double d = bank.imaginary;
        rowReal = scale * (a - leak * c);
        rowImaginary = scale * (b - leak * d);
        columnReal = scale * (c - leak * a);
        columnImaginary = scale * (d - leak * b);
        double row2 = rowReal * rowReal + rowImaginary * rowImaginary;
        double column2 = columnReal * columnReal + columnImaginary * columnImaginary;
        return Math.sqrt(Math.sqrt(row2 * column2));
    }
}
