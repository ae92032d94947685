package simgsm.tools;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import simgsm.console.ExitStatus;
import simgsm.dtmf.ClassicReceiver;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.KeyCandidate;
import simgsm.dtmf.KeyReceiver;
import simgsm.file.FileErrors;
import simgsm.tools.audio.NotAudioException;
import simgsm.tools.audio.SpeechFile;

/** The result of {@code decode} for one file. */
final class DecodedFile {
    /** The receiver of the files. */
    record Kind(boolean explains, double limit, boolean isClassic, int classicBlockSamples) {
        KeyReceiver open(DtmfListener listener, Consumer<KeyCandidate> candidates) {
            return isClassic
                    ? new ClassicReceiver(listener, candidates, classicBlockSamples)
                    : new DtmfReceiver(listener, explains ? candidates : null, limit);
        }
    }

    private static final int BLOCK_SAMPLES = 8192;

    private final String name;
    private final StringBuilder keys = new StringBuilder();
    private final StringBuilder millis = new StringBuilder();
    private final StringBuilder candidates = new StringBuilder();
    private final Kind kind;
    private int status = ExitStatus.OK;
    private String error;

    private DecodedFile(String name, Kind kind) {
        this.name = name;
        this.kind = kind;
    }

    /** Decodes the file; errors of the file are part of the result. */
    static DecodedFile of(String name, Kind kind) {
        DecodedFile decoded = new DecodedFile(name, kind);
        try {
            Path file = Path.of(name);
            FileErrors.naming(file, () -> decoded.decode(file));
        } catch (NotAudioException e) {
            decoded.failed(ExitStatus.FAILED, e.getMessage());
        } catch (IOException e) {
            decoded.failed(ExitStatus.INPUT_OUTPUT, FileErrors.describe(e));
        }
        return decoded;
    }

    private void failed(int newStatus, String text) {
        status = newStatus;
        error = text;
    }

    private void decode(Path path) throws IOException {
        try (SpeechFile file = SpeechFile.openForKeys(path)) {
            KeyReceiver receiver = kind.open(
                    listener(file.lookAheadMillis()), candidate -> explain(candidate, file.lookAheadMillis()));
            short[] block = new short[BLOCK_SAMPLES];
            for (int n; (n = file.read(block)) >= 0; ) {
                receiver.accept(block, 0, n);
            }
            receiver.finish();
            if (file.missingOctets() > 0) {
                failed(ExitStatus.FAILED, path + ": ends " + file.missingOctets() + " octets before its header says");
            }
        }
    }

    private DtmfListener listener(double lookAheadMillis) {
        return digit -> {
            keys.append(digit.key().symbol());
            millis.append(millis.length() == 0 ? "" : ",")
                    .append(Math.round(digit.decidedAtSample() / 8.0 + lookAheadMillis));
        };
    }

    private void explain(KeyCandidate candidate, double lookAheadMillis) {
        if (!kind.explains() || !candidate.isOver()) {
            return;
        }
        candidates
                .append("  explain\t")
                .append(candidate.key().symbol())
                .append('\t')
                .append(Math.round(candidate.fromSample() / 8.0 + lookAheadMillis))
                .append('\t')
                .append(Math.round(candidate.toSample() / 8.0 + lookAheadMillis))
                .append('\t')
                .append(candidate.isAccepted() ? "accepted" : "rejected")
                .append('\t')
                .append(candidate.reason())
                .append('\n');
    }

    int status() {
        return status;
    }

    /** The reason of a failure; null if there is none. */
    String error() {
        return error;
    }

    String line() {
        return name + "\t" + keys + "\t" + millis + "\n" + candidates;
    }
}
