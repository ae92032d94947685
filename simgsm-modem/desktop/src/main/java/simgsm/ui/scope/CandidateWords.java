package simgsm.ui.scope;

import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.dtmf.KeyCandidate;
import simgsm.dtmf.KeyCandidate.Finding;

/** A candidate key's finding in words: the reason why it is a key, or is none. */
final class CandidateWords {
    private CandidateWords() {}

    static String of(TextBundle texts, KeyCandidate candidate) {
        Finding finding = candidate.finding();
        String measure =
                finding == Finding.EVIDENCE ? texts.of("scope.measure." + candidate.measure(), number(candidate)) : "";
        return texts.of(
                "scope.finding." + finding.name(),
                String.valueOf(candidate.key().symbol()),
                number(candidate),
                decimal(candidate.score()),
                decimal(candidate.limit()),
                measure);
    }

    private static String number(KeyCandidate candidate) {
        return decimal(candidate.value());
    }

    private static String decimal(double value) {
        String text = String.format(Locale.ROOT, "%.1f", value);
        return text.replace("-0.0", "0.0").replace('-', '\u2212');
    }
}
