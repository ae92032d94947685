package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.zxing.common.BitMatrix;
import com.google.zxing.qrcode.decoder.Decoder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Codes are read by ZXing. */
class QrCodeTest {
    @ParameterizedTest
    @CsvSource({"1,21", "17,21", "18,25", "32,25", "33,29", "53,29", "54,33", "78,33", "79,37", "106,37"})
    void aTextOfEachLengthIsReadFromTheSmallestVersion(int octets, int size) throws Exception {
        String text = "http://192.168.1.23:8080/#".repeat(5).substring(0, octets);
        QrCode code = new QrCode(text);
        assertEquals(size, code.size());
        BitMatrix matrix = new BitMatrix(size);
        for (int row = 0; row < size; row++) {
            for (int column = 0; column < size; column++) {
                if (code.isDark(column, row)) {
                    matrix.set(column, row);
                }
            }
        }
        assertEquals(text, new Decoder().decode(matrix).getText());
    }

    @Test
    void aLongerTextIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new QrCode("x".repeat(107)));
    }
}
