package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PoseTest {
    @ParameterizedTest
    @CsvSource({"0, 0.00", "359.994, 359.99", "359.996, 0.00", "360, 0.00", "-90, 270.00", "-0.001, 0.00", "725.5, 5.50"
    })
    void aHeadingIsWrittenInZeroTo360(double degrees, String text) {
        assertEquals(text, new Pose(0, 0, degrees).headingText(2));
    }

    @Test
    void placesHaveADotAndNoMinusZero() {
        Pose pose = new Pose(-0.00001, -12.34567, 0);
        assertEquals("0.0000", pose.xText(4));
        assertEquals("-12.346", pose.yText(3));
    }
}
