package simgsm.scope;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.KeyCandidate;
import simgsm.dtmf.ToneLevels;
import simgsm.dtmf.ToneShape;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneExperiment;
import simgsm.tone.ToneLevel;

/** What the tone scope measures. */
class ToneTracerTest {
    /** The receiver's lowest level, and its largest difference of two tones. */
    private static final double LEAST_DBM0 = -50;

    private static final double MOST_TWIST_DB = 13;
    private final ToneTracer tracer = new ToneTracer();
    private final DtmfGenerator generator = new DtmfGenerator();

    private ReceiverTrace modem() {
        return tracer.newest().modem();
    }

    private ToneLevels levels() {
        return modem().levels();
    }

    private void pass(int frames) {
        for (int i = 0; i < frames; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
    }

    @ParameterizedTest
    @EnumSource(DtmfKey.class)
    void theTwoFrequenciesOfAKeyStandAtTheirLevelAndTheOthersFarBelow(DtmfKey key) {
        generator.enqueue(key);
        pass(4);
        for (int i = 0; i < 4; i++) {
            double row = levels().dbm0(i);
            double column = levels().dbm0(4 + i);
            assertEquals(i == key.row(), row > -12, "row " + i + " at " + row);
            assertEquals(i == key.column(), column > -12, "column " + i + " at " + column);
        }
        assertEquals(-10, levels().dbm0(key.row()), 0.7);
        assertEquals(-10, levels().dbm0(4 + key.column()), 0.7);
    }

    @Test
    void theKeySoundsAndThenHasSounded() {
        generator.enqueue(DtmfKey.SEVEN);
        pass(4);
        assertTrue(modem().isSounding());
        pass(6);
        assertFalse(modem().isSounding());
        assertEquals(DtmfKey.SEVEN, modem().digit().orElseThrow().key());
        assertEquals(100, modem().digit().orElseThrow().durationMillis(), 10);
    }

    /** Ten keys, as the scope hears them under an experiment. */
    private ToneScore score(double snrDecibels, double shiftPercent) {
        tracer.tryOut(new ToneExperiment(snrDecibels, shiftPercent));
        DtmfKey.sequence("1234567890").forEach(generator::enqueue);
        pass(110);
        return modem().score();
    }

    @Test
    void aLittleNoiseIsNoHindrance() {
        assertEquals(new ToneScore(10, 0, 0), score(15, 0));
    }

    @Test
    void inMuchNoiseKeysAreMissed() {
        ToneScore score = score(-15, 0);
        assertEquals(10, score.keys());
        assertTrue(score.missed() >= 8, score.toString());
    }

    @Test
    void noiseIsMeasuredAgainstTheTones() {
        tracer.tryOut(new ToneExperiment(0, 0));
        short[] silence = new short[160];
        generator.enqueue(DtmfKey.ONE);
        pass(5);
        for (int i = 0; i < 3; i++) {
            tracer.accept(silence);
        }
        double sum = 0;
        for (int i = 0; i < ToneTrace.SAMPLES; i++) {
            sum += Math.pow(tracer.newest().heard().last(ToneTrace.SAMPLES)[i], 2);
        }
        double decibels = 10 * Math.log10(sum / ToneTrace.SAMPLES / Math.pow(ToneLevel.amplitude(-10), 2));
        assertEquals(0, decibels, 1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1.5, -0.5, 0.5, 1.5})
    void aSmallShiftIsHeardAndMeasured(double percent) {
        assertEquals(new ToneScore(10, 0, 0), score(Double.POSITIVE_INFINITY, percent));
        assertEquals(percent, modem().digit().orElseThrow().frequencyErrorPercent(), 0.15);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-4, 4})
    void aLargeShiftIsNoKey(double percent) {
        assertEquals(new ToneScore(0, 10, 0), score(Double.POSITIVE_INFINITY, percent));
    }

    @Test
    void anExperimentLeavesTheSoundAsItIs() {
        tracer.tryOut(new ToneExperiment(0, 3));
        generator.enqueue(DtmfKey.FIVE);
        short[] frame = new short[160];
        generator.read(frame);
        short[] before = frame.clone();
        tracer.accept(frame);
        assertArrayEquals(before, frame);
    }

    @Test
    void everyNewExperimentBeginsItsScoreAnew() {
        score(15, 0);
        tracer.tryOut(new ToneExperiment(14, 0));
        assertEquals(ToneScore.NONE, modem().score());
        assertEquals(14, tracer.newest().experiment().snrDecibels());
    }

    /** The dashed lines mean what they say: just above them a key is heard, below the lowest it is not. */
    @Test
    void theThresholdsAreTheReceivers() {
        double level = LEAST_DBM0 + 3;
        generator.enqueue(DtmfKey.FIVE, ToneShape.STANDARD.withLevel(level));
        pass(10);
        assertEquals(DtmfKey.FIVE, modem().digit().orElseThrow().key());
        generator.enqueue(DtmfKey.NINE, ToneShape.STANDARD.withLevel(LEAST_DBM0 - 1));
        generator.enqueue(DtmfKey.NINE, new ToneShape(100, 100, -10, -10 - MOST_TWIST_DB - 1, 0));
        pass(20);
        assertEquals(DtmfKey.FIVE, modem().digit().orElseThrow().key());
        generator.enqueue(DtmfKey.ZERO, new ToneShape(100, 100, -10, -16, 0));
        pass(4);
        assertEquals(-16 - MOST_TWIST_DB, levels().leastDbm0(0), 1);
        assertEquals(-10 - MOST_TWIST_DB, levels().leastDbm0(4), 1);
    }

    @Test
    void whenNoSoundComesThePictureRestsAndTheLastKeyStays() {
        tracer.tryOut(new ToneExperiment(10, 0));
        generator.enqueue(DtmfKey.FIVE);
        pass(4);
        tracer.rest();
        ToneTrace trace = tracer.newest();
        assertFalse(trace.modem().isSounding());
        assertEquals(ToneLevels.FLOOR_DBM0, trace.modem().levels().dbm0(1));
        assertEquals(DtmfKey.FIVE, trace.modem().digit().orElseThrow().key());
    }

    @Test
    void silenceAfterSilenceChangesNothing() {
        ToneTrace before = tracer.newest();
        assertFalse(tracer.accept(new short[160]));
        assertSame(before, tracer.newest());
    }

    @Test
    void thePictureGoesQuietAfterATone() {
        generator.enqueue(DtmfKey.ONE);
        pass(20);
        assertEquals(0, tracer.newest().heard().last(1)[0]);
        assertEquals(ToneLevels.FLOOR_DBM0, levels().dbm0(0));
    }

    @Test
    void aResetForgetsAll() {
        generator.enqueue(DtmfKey.ONE);
        pass(4);
        tracer.reset();
        assertSame(ToneTrace.EMPTY, tracer.newest());
    }

    /** What both receivers heard of five keys. */
    private String bothHear(ToneShape shape) {
        DtmfKey.sequence("12345").forEach(key -> generator.enqueue(key, shape));
        pass(60);
        return heard(tracer.newest().modem()) + "/" + heard(tracer.newest().classic());
    }

    private static String heard(ReceiverTrace trace) {
        return trace.candidates().stream()
                .filter(KeyCandidate::isAccepted)
                .map(candidate -> String.valueOf(candidate.key().symbol()))
                .collect(Collectors.joining());
    }

    @Test
    void bothReceiversHearTheSameSamples() {
        assertEquals("12345/12345", bothHear(ToneShape.STANDARD));
    }

    @Test
    void aTwistBeyondQ24IsTooMuchForTheClassicReceiverOnly() {
        assertEquals("12345/", bothHear(new ToneShape(100, 100, -16, -9, 0)));
        KeyCandidate last = tracer.newest().classic().candidates().get(4);
        assertEquals(KeyCandidate.Finding.TWIST, last.finding());
        assertEquals(7, last.value(), 1);
        assertEquals(0, last.climbed());
        assertFalse(tracer.newest().classic().levels().counts(5), "the row's tone lies below its limit");
    }

    @Test
    void noiseTooLoudForTheClassicReceiverLeavesEnoughForTheOther() {
        tracer.tryOut(new ToneExperiment(3, 0));
        bothHear(ToneShape.STANDARD);
        assertEquals(new ToneScore(5, 0, 0), modem().score());
        assertEquals(new ToneScore(0, 5, 0), tracer.newest().classic().score());
    }

    @Test
    void aCandidatesBarPassesTheLineWhenItIsAKey() {
        generator.enqueue(DtmfKey.FIVE);
        pass(4);
        for (ReceiverTrace each : List.of(modem(), tracer.newest().classic())) {
            KeyCandidate candidate = each.candidates().get(0);
            assertEquals(DtmfKey.FIVE, candidate.key());
            assertTrue(candidate.climbed() >= 1, candidate.toString());
        }
    }

    @Test
    void aTraceHasTheSoundBeforeAndAfterACodec() {
        ToneTracer tracer = new ToneTracer();
        tracer.tryOut(new ToneExperiment(Double.POSITIVE_INFINITY, 0, Optional.of(SpeechCodec.Kind.GSM_FULL_RATE)));
        short[] sent = new short[1600];
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(DtmfKey.FIVE, 200, 0);
        generator.read(sent);
        for (int at = 0; at < sent.length; at += 160) {
            tracer.accept(Arrays.copyOfRange(sent, at, at + 160));
        }
        ToneTrace trace = tracer.newest();

        assertArrayEquals(sent, trace.original().last(sent.length));
        SpeechCodec coder = SpeechCodec.Kind.GSM_FULL_RATE.open();
        SpeechCodec decoder = SpeechCodec.Kind.GSM_FULL_RATE.open();
        short[] received = new short[sent.length];
        for (int at = 0; at < sent.length; at += 160) {
            short[] frame = decoder.decode(coder.encode(Arrays.copyOfRange(sent, at, at + 160)));
            System.arraycopy(frame, 0, received, at, 160);
        }
        assertArrayEquals(received, trace.heard().last(sent.length));
        assertEquals(-10, trace.originalLevels().dbm0(1), 1);
    }

    @Test
    void aStretchOfSoundIsTheLastTwoSecondsAndSilenceBefore() {
        ToneTracer tracer = new ToneTracer();
        tracer.accept(filled(160, 1000));
        short[] last = tracer.newest().heard().last(320);
        assertEquals(0, last[159]);
        assertEquals(1000, last[160]);
        for (int i = 0; i < 200; i++) {
            tracer.accept(filled(160, i));
        }
        short[] all = tracer.newest().heard().last(SoundStretch.SAMPLES + 320);
        assertEquals(199, all[all.length - 1]);
        assertEquals(0, all[159]);
    }

    private static short[] filled(int length, int value) {
        short[] samples = new short[length];
        Arrays.fill(samples, (short) value);
        return samples;
    }
}
