/**
 * Call and message records: one CSV file a day, for accounting and statistics. Read first {@link
 * simgsm.center.records.DetailRecords}.
 */
package simgsm.center.records;
