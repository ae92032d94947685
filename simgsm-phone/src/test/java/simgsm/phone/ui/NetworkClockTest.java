package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.image.BufferedImage;
import java.time.LocalTime;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.util.Arrays;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import simgsm.phone.handset.Bench;
import simgsm.station.context.StationEvent;

/** The clock of the display; the machine's is at noon, UTC. */
class NetworkClockTest {
    private final PanelBench bench = new PanelBench(Locale.ENGLISH);

    private void networkSends(String time) {
        bench.bench.handset.accept(new StationEvent.NetworkTimeReceived(OffsetDateTime.parse(time)));
    }

    private LocalTime shown(int minutesLater) {
        ZonedDateTime machine = Bench.NOON.atZone(ZoneOffset.UTC).plusMinutes(minutesLater);
        return bench.bench.snapshot().clock().at(machine).toLocalTime();
    }

    private int[] picture() {
        BufferedImage image = bench.paint(1);
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void theClockIsTheMachinesUntilTheNetworkSendsItsTimeAndRunsOnFromThere() {
        assertEquals(LocalTime.of(12, 0), shown(0));
        networkSends("2026-11-21T15:31:20+02:00");
        assertEquals(LocalTime.of(15, 31, 20), shown(0));
        assertEquals(LocalTime.of(15, 41, 20), shown(10));
    }

    @Test
    void theDisplayShowsTheNetworksTime() {
        int[] noon = picture();
        networkSends("2026-11-21T15:31:20+02:00");
        assertFalse(Arrays.equals(noon, picture()));
        networkSends("2026-11-21T12:00:59+00:00");
        assertArrayEquals(noon, picture());
    }
}
