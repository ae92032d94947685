package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** The receiver against a few recordings of every kind; the whole bench is {@link Bench}'s main. */
class CatalogueTest {
    private static final int TAPES = 4;

    private static double exactShare(Catalogue.Grade grade, Bench bench) {
        int exact = 0;
        int tapes = 0;
        for (Catalogue.Kind kind : Catalogue.kinds()) {
            if (kind.grade() == grade) {
                Bench.Row row = bench.run(kind, TAPES, 8_100);
                exact += row.exact();
                tapes += row.tapes();
            }
        }
        return 100.0 * exact / tapes;
    }

    @Test
    void ofRequiredRecordings99InAHundredAreHeardExactlyAndInTime() {
        Bench bench = new Bench();
        double share = exactShare(Catalogue.Grade.REQUIRED, bench);
        assertTrue(share >= 99, share + " %\n" + bench.failures());
        assertTrue(bench.delay(0) >= 23, "earliest " + bench.delay(0) + " ms");
        assertTrue(bench.delay(0.5) <= 30, "median " + bench.delay(0.5) + " ms");
        assertTrue(bench.delay(0.95) <= 33, "95 % " + bench.delay(0.95) + " ms");
    }

    @Test
    void ofHarderRecordings85InAHundredAreHeardExactly() {
        Bench bench = new Bench();
        double share = exactShare(Catalogue.Grade.HARDER, bench);
        assertTrue(share >= 85, share + " %\n" + bench.failures());
    }

    @Test
    void whatIsNoKeyIsNotHeard() {
        Bench bench = new Bench();
        double share = exactShare(Catalogue.Grade.SILENT, bench);
        assertEquals(100, share, 1, bench.failures());
    }

    @Test
    void theSameSeedMakesTheSameRecording() {
        Catalogue.Kind kind = Catalogue.kinds().get(0);
        short[] one = kind.maker().apply(7L).samples();
        short[] other = kind.maker().apply(7L).samples();
        org.junit.jupiter.api.Assertions.assertArrayEquals(one, other);
    }
}
