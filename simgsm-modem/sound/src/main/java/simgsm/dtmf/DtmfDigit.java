package simgsm.dtmf;

import java.util.OptionalInt;

/**
 * A detected key.
 *
 * @param decidedAtSample number of samples received at the decision
 * @param startedAtSample estimated start of its tone
 * @param durationSamples of its tone so far; final after its end
 * @param rowDbm0 level of the low-group tone
 * @param columnDbm0 level of the high-group tone
 * @param rowError frequency error of the low-group tone as a fraction, 0.01 for 1 % high
 * @param columnError frequency error of the high-group tone as a fraction
 */
public record DtmfDigit(
        DtmfKey key,
        long decidedAtSample,
        long startedAtSample,
        long durationSamples,
        double rowDbm0,
        double columnDbm0,
        double rowError,
        double columnError) {

    /**
     * A key reported from elsewhere, as by a modem: levels and errors are NaN.
     *
     * @param millis duration of the key; empty if unknown, the duration is 0 then
     */
    public static DtmfDigit reported(DtmfKey key, long decidedAtSample, OptionalInt millis) {
        long duration = 8L * millis.orElse(0);
        return new DtmfDigit(
                key,
                decidedAtSample,
                Math.max(0, decidedAtSample - duration),
                duration,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Double.NaN);
    }

    /** True if the tones were measured here. */
    public boolean isMeasured() {
        return !Double.isNaN(rowDbm0);
    }

    /** High group over low group (ITU-T Q.24). */
    public double twistDecibels() {
        return columnDbm0 - rowDbm0;
    }

    public double durationMillis() {
        return durationSamples / 8.0;
    }

    /** The larger of the two tones' errors, in percent with its sign. */
    public double frequencyErrorPercent() {
        return 100 * (Math.abs(rowError) > Math.abs(columnError) ? rowError : columnError);
    }

    DtmfDigit withDuration(long samples) {
        return new DtmfDigit(
                key, decidedAtSample, startedAtSample, samples, rowDbm0, columnDbm0, rowError, columnError);
    }
}
